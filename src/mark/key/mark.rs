//! One mark of a scheme, as a key has it.

use std::sync::OnceLock;

use crate::bank::{Code, EarnedFor};
use crate::expr::Expr;
use crate::mark::judging::Model;

/// One mark of a scheme.
#[derive(Clone, Debug)]
pub struct KeyedMark {
    /// Its id within the part: `M1a`.
    pub id: String,
    /// Its code.
    pub code: Code,
    /// The step that earns it.
    pub earned_for: EarnedFor,
    /// The marks of the part without which it is not given.
    pub depends: Vec<usize>,
    /// The blanks to which it belongs.
    pub blanks: Vec<usize>,
    /// The equation or value that earns it.
    pub equation: Option<Expr>,
    /// What a line that states its value, or the second of two, is judged by, in either positive direction.
    pub(super) stated: [[OnceLock<Option<Model>>; 2]; 2],
}

impl KeyedMark {
    /// The model that a line stating a value of the mark is judged by, made when it is first needed.
    pub(in crate::mark) fn stated(
        &self,
        value: usize,
        is_reversed: bool,
        make: impl FnOnce() -> Option<Model>,
    ) -> Option<&Model> {
        self.stated[value][usize::from(is_reversed)].get_or_init(make).as_ref()
    }
}
