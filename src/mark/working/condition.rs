//! Lines that use what is given of the motion after the impact.

use super::evidence::Evidence;
use super::examine::Working;
use super::points::sizes;
use crate::expr::Expr;
use crate::mark::key::KeyedMark;

impl Working<'_> {
    /// A line that holds only because of what is given of the motion after the impact.
    pub(super) fn uses_condition(&self, mark: &KeyedMark) -> Option<Evidence> {
        if mark.code.is_accuracy() {
            return None;
        }
        let line = self.lines.iter().position(|studied| {
            let Some(reading) = &studied.reading else { return false };
            !self.is_printed_result(studied)
                && studied.matched.is_empty()
                && reading.equations.iter().any(|equation| self.holds_only_where_found(equation))
        })?;
        Some(Evidence::given(line, "uses what is given of the motion after the impact"))
    }

    fn holds_only_where_found(&self, (left, right): &(Expr, Expr)) -> bool {
        let mut held = 0;
        for point in 0..self.prepared.points.count {
            let Some(there) = self.prepared.where_found(point) else { continue };
            let at = |quantity| Some(vec![there.number(quantity)?; self.prepared.points.count]);
            let names = self.names(&at);
            let points = self.prepared.points.with(&self.prepared.found, point);
            let context = super::linear::Context {
                points: &points,
                given: &names,
                ..super::examine::context(self.prepared, point)
            };
            let Some(difference) = super::linear::difference(left, right, &context) else { return false };
            let super::linear::Sum::Number(linear) = difference else { return false };
            if !linear.is_number() || !linear.constant.may_be_nought(linear.size * 100.0) {
                return false;
            }
            held += 1;
        }
        // And not everywhere: an identity says nothing.
        held > 0 && !(0..self.prepared.points.count).all(|point| self.holds_at(left, right, point))
    }

    fn holds_at(&self, left: &Expr, right: &Expr, point: usize) -> bool {
        let names = self.names(&|quantity| sizes(&self.prepared.known, quantity));
        let context = super::linear::Context { given: &names, ..super::examine::context(self.prepared, point) };
        match super::linear::difference(left, right, &context) {
            Some(super::linear::Sum::Number(linear)) => {
                linear.is_number() && linear.constant.may_be_nought(linear.size)
            }
            _ => false,
        }
    }
}
