//! The names that there are at a place in a template.

use std::collections::BTreeMap;

use super::names::{Kind, names_of};

/// Names by what they stand for, the innermost loop last.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Scope<'t> {
    frames: Vec<Frame<'t>>,
}

/// The names of a template or of one loop in it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Frame<'t> {
    is_loop: bool,
    names: BTreeMap<&'t str, Kind>,
}

impl<'t> Scope<'t> {
    /// Where nothing has been set yet.
    pub fn page() -> Scope<'t> {
        Scope::of(names_of("").iter().copied().collect())
    }

    /// Where nothing has been set yet on a page that has one name, of which all others are: `class`, `feedback` on what a
    /// student gets back, `report` on how a class did.
    pub fn only(thing: &'static str) -> Scope<'t> {
        Scope::of(BTreeMap::from([(thing, Kind::Thing(thing))]))
    }

    /// Where there are these names and no loop.
    pub fn of(names: BTreeMap<&'t str, Kind>) -> Scope<'t> {
        Scope { frames: vec![Frame { is_loop: false, names }] }
    }

    /// What a template sees that is included here: every name, but not the loop.
    pub fn included(&self) -> Scope<'t> {
        Scope::of(self.frames.iter().flat_map(|frame| &frame.names).map(|(name, kind)| (*name, *kind)).collect())
    }

    /// What a name stands for.
    pub fn get(&self, name: &str) -> Option<Kind> {
        self.frames.iter().rev().find_map(|frame| frame.names.get(name).copied())
    }

    /// Is there a `loop` to ask?
    pub fn in_loop(&self) -> bool {
        self.frames.iter().any(|frame| frame.is_loop)
    }

    /// All names, sorted.
    pub fn names(&self) -> Vec<&'t str> {
        let mut names: Vec<&'t str> = self.frames.iter().flat_map(|frame| frame.names.keys().copied()).collect();
        names.extend(self.in_loop().then_some("loop"));
        names.sort_unstable();
        names.dedup();
        names
    }

    /// A loop begins; these are its names.
    pub fn enter_loop(&mut self, names: impl IntoIterator<Item = (&'t str, Kind)>) {
        self.frames.push(Frame { is_loop: true, names: names.into_iter().collect() });
    }

    /// The loop ends, and what was set in it is gone.
    pub fn leave_loop(&mut self) {
        if self.frames.len() > 1 {
            self.frames.pop();
        }
    }

    /// A name is set here.
    pub fn set(&mut self, name: &'t str, kind: Kind) {
        if let Some(frame) = self.frames.last_mut() {
            frame.names.insert(name, kind);
        }
    }

    /// A name is set for the whole template.
    pub fn set_global(&mut self, name: &'t str, kind: Kind) {
        self.frames[0].names.insert(name, kind);
    }
}
