//! Lines whose notation is open to doubt: what was meant is the reading in which they are true.
//!
//! `tan β = u sin α/½u(1 − e) cos α = 2 tan α/(1 − e)` has all of it below the stroke. What stands before a line tells which
//! letters are known, so it is decided once they are.

use std::rc::Rc;

use super::line::ReadLine;
use crate::mark::working::examine::Working;
use crate::mark::working::laws::{Spot, Truth};

impl Working<'_> {
    /// Takes another reading of each line that is neither law and is false as it would be read, if that one is true.
    pub(in crate::mark::working) fn settle_doubts(&mut self) {
        let doubtful = self.lines.iter().enumerate().filter(|(_, studied)| {
            studied.reading.is_some() && studied.matched.is_empty() && studied.line.readings.len() > 1
        });
        let doubtful: Vec<usize> = doubtful.map(|(place, _)| place).collect();
        if doubtful.is_empty() {
            return;
        }
        let at = |point| Spot { points: self.prepared.points.clone(), point, names: self.names.clone() };
        let spots: Vec<Spot> = (0..self.prepared.points.count).map(at).collect();
        let meant = doubtful.into_iter().filter_map(|place| {
            let studied = &self.lines[place];
            let is = |reading: &ReadLine, truth: Truth| {
                self.truth_of_all(&self.equations(reading, None).0, &spots, &[]) == truth
            };
            if !is(studied.reading.as_ref()?, Truth::False) {
                return None;
            }
            let meant = studied.line.readings.iter().find(|reading| is(reading, Truth::True));
            meant.map(|reading| (place, Rc::clone(reading)))
        });
        for (place, reading) in meant.collect::<Vec<_>>() {
            self.lines[place].reading = Some(reading);
        }
    }
}
