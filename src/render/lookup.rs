//! Names looked up: what each stands for, which are asked for in vain, and which not at all.

use std::collections::{BTreeMap, BTreeSet};

use super::code::Word;
use super::fault::{a, listed};
use super::names::{Kind, names_of};
use super::scope::Scope;
use crate::diagnostic::{Diagnostic, Source, near};

/// What the templates of a format ask for.
#[derive(Clone, Debug, Default)]
pub(super) struct Found<'t> {
    /// Names that there are not.
    pub faults: Vec<Diagnostic>,
    /// Names that there are, each with its thing.
    pub used: BTreeSet<(&'static str, &'static str)>,
    /// Whether a thing is used as a whole, so that all its names count as used.
    pub whole: bool,
    /// Components called, with what they are given, in the order of the calls.
    pub calls: Vec<(String, BTreeMap<&'t str, Kind>)>,
}

impl<'t> Found<'t> {
    /// A name by itself.
    pub fn name(&mut self, word: Word<'t>, scope: &Scope<'t>, source: &Source) -> Kind {
        if word.text == "__tera_context" {
            self.whole = true;
            return Kind::Anything;
        }
        let Some(kind) = scope.get(word.text) else {
            let names = scope.names();
            let label = format!("the names here are {}", listed(&names));
            let fault = Diagnostic::new(format!("unknown name `{}`", word.text), source, word.span(), label);
            self.faults.push(fault.with_near(near(word.text, names)));
            return Kind::Anything;
        };
        if let Some((name, _)) = names_of("").iter().find(|(name, _)| *name == word.text) {
            self.used.insert(("", name));
        }
        kind
    }

    /// A name of a thing; the fault is shown at a word, which may hold more than the name.
    pub fn field(&mut self, of: Kind, name: &str, word: Word<'t>, source: &Source) -> Kind {
        let unknown = |whose: &str| format!("unknown name `{name}` of {whose}");
        let fault = match of {
            Kind::Anything => return Kind::Anything,
            Kind::Thing(thing) => {
                if let Some((name, kind)) = names_of(thing).iter().find(|(known, _)| *known == name) {
                    self.used.insert((thing, name));
                    return *kind;
                }
                let names: Vec<&str> = names_of(thing).iter().map(|(name, _)| *name).collect();
                let label = format!("{} has {}", a(thing), listed(&names));
                Diagnostic::new(unknown(&a(thing)), source, word.span(), label).with_near(near(name, names))
            }
            Kind::Things(thing) => {
                let label = format!("it is a list: only each {thing} in it has names");
                let fault = Diagnostic::new(unknown("a list"), source, word.span(), label);
                fault.with_help(format!("go through the list with `for {thing} in …`, or take one with `| first`"))
            }
            Kind::Plain | Kind::Plains => {
                let label = "what stands before it is only printed, and has no names";
                Diagnostic::new(format!("unknown name `{name}`"), source, word.span(), label)
            }
        };
        self.faults.push(fault);
        Kind::Anything
    }

    /// One of two, as the paper has it.
    pub fn either(&mut self, one: Kind, other: Kind) -> Kind {
        if one == other {
            return one;
        }
        self.as_whole(one);
        self.as_whole(other);
        Kind::Anything
    }

    /// Asked only whether it is there.
    pub fn truth(&mut self, kind: Kind) -> Kind {
        if let Kind::Thing(_) = kind { self.as_whole(kind) } else { Kind::Plain }
    }

    /// Used so that it matters what else is in it.
    pub fn as_whole(&mut self, kind: Kind) -> Kind {
        self.whole |= matches!(kind, Kind::Thing(_) | Kind::Things(_));
        Kind::Plain
    }
}
