//! The ways to wrong values: the derivation carried out again, on every road, with each slip, with pairs of them, with what
//! the calculator makes of the numbers, and with what goes wrong in the last line.

use crate::mechanics::{Carried, Datum, Known, MadeSlip, Quantity, Road, Slip, Sought, Steps, Trace};
use crate::number::{Letter, Value};

use super::asked::Asked;
use super::backwards::{Backwards, Landed};
use super::sample::{Sample, sampled};
use super::table::{Answer, Values};
use super::{Mistakes, Origin, SAME, Way, angle_of, calculator, last_step};

/// The most pairs of slips that are tried.
const MOST_PAIRS: usize = 200;

/// A slip by itself at every impact, as it was found on a road.
struct Single {
    slip: usize,
    road: usize,
    slipped: Steps,
    /// Does it change the answer of that place?
    changes: u64,
}
impl Mistakes {
    /// Works out what each slip leads to, for answers that are one quantity each, the components of a vector, or what is
    /// found backwards.
    ///
    /// `given` is what the scene gives, as `pose` has it, with its unknowns found; `letters` are those of the question, and
    /// `sought` is what its unknown was found from.
    pub fn of(given: &Known<Value>, answers: &[Asked], letters: &[Letter], sought: Option<&Sought>) -> Mistakes {
        let mut mistakes = Mistakes {
            roads: Vec::new(),
            ways: Vec::new(),
            answers: Vec::new(),
            letters: letters.to_vec(),
            backwards: None,
        };
        let Some(given) = sampled(given) else { return mistakes };
        let quantities = || answers.iter().map(Asked::quantities);
        let mut asked: Vec<Quantity> = quantities().flatten().copied().collect();
        asked.extend(quantities().filter_map(angle_of).flatten());
        asked.extend(quantities().flatten().flat_map(|quantity| last_step::taken_for(*quantity)).map(|(q, _)| q));
        asked.extend(sought.iter().flat_map(|sought| &sought.asked));
        asked.sort();
        asked.dedup();
        mistakes.roads = roads(&given, &asked);
        mistakes.backwards = sought.and_then(|sought| Backwards::of(sought, &mut mistakes.roads[0]));
        let known = mistakes.roads[0].known();
        let angles = quantities().filter_map(angle_of);
        let all = quantities().map(<[Quantity]>::to_vec).chain(angles);
        let mut found: Vec<Answer> = all.filter_map(|answer| Answer::of(&answer, known)).collect();
        if let Some(backwards) = &mistakes.backwards {
            for asked in answers.iter().filter(|asked| asked.quantities().is_empty()) {
                let each = (0..backwards.count()).map(|place| Answer::of_letter(asked, backwards, place));
                found.extend(each.filter(|_| backwards.is_range == (*asked == Asked::Ends)));
            }
        }
        mistakes.answers = found;
        let singles = mistakes.add_singles();
        mistakes.add_calculator();
        mistakes.add_last_steps();
        mistakes.add_pairs(&singles);
        mistakes
    }
    fn add(&mut self, way: Way, found: impl Iterator<Item = (usize, Values)>) {
        let number = self.ways.len();
        let mut is_used = false;
        for (answer, values) in found {
            self.answers[answer].add(values, number);
            is_used = true;
        }
        if is_used {
            self.ways.push(way);
        }
    }

    /// Carries out a road again; the wrong values that come of it, each with the place of its answer.
    fn again(
        &mut self,
        road: usize,
        slips: &[MadeSlip],
        other: &[(Quantity, Datum<Sample>)],
    ) -> (Trace, Vec<(usize, Values)>) {
        self.roads[road].again(slips, other, look_for_wrong(&self.answers))
    }

    /// The same of what is found backwards, and of the other answers where it has come out otherwise.
    fn again_backwards(
        &mut self,
        road: usize,
        slips: &[MadeSlip],
        other: &[(Quantity, Datum<Sample>)],
    ) -> Vec<(usize, Values)> {
        let (Some(backwards), answers) = (&self.backwards, &self.answers) else { return Vec::new() };
        let road = &mut self.roads[road];
        let mut wrong = Vec::new();
        for place in 0..backwards.count() {
            let Some(Landed { number, .. }) = backwards.found(place, road, slips, other) else { continue };
            if number.is_near(backwards.right(place).number, SAME) {
                continue;
            }
            let of_letter = answers.iter().enumerate();
            let of_letter = of_letter.filter(|(_, answer)| answer.quantities().is_empty() && answer.place == place);
            wrong.extend(of_letter.map(|(at, _)| (at, vec![backwards.in_figures(number)])));
            if !backwards.is_range {
                let other: Vec<_> = backwards.given_at(number).into_iter().chain(other.iter().cloned()).collect();
                wrong.extend(road.again(slips, &other, look_for_wrong(answers)).1);
            }
        }
        wrong
    }

    fn add_singles(&mut self) -> Vec<Single> {
        let mut singles = Vec::new();
        for (slip, owned) in Slip::all().iter().enumerate() {
            let mut is_found_again = false;
            let everywhere = [MadeSlip::everywhere(*owned)];
            for road in 0..self.roads.len() {
                let (trace, mut wrong) = self.again(road, &everywhere, &[]);
                // What is found backwards costs ten times as much, and hardly ever depends on the road.
                if !trace.slipped.is_empty() && !std::mem::replace(&mut is_found_again, true) {
                    wrong.extend(self.again_backwards(road, &everywhere, &[]));
                }
                if trace.slipped.is_empty() || wrong.is_empty() {
                    continue;
                }
                let changes = wrong.iter().fold(0, |changes, (answer, _)| changes | 1_u64.wrapping_shl(*answer as u32));
                singles.push(Single { slip, road, slipped: trace.slipped, changes });
                self.add_slip(slip, None, road, trace, wrong);
            }
            // Who makes it at one impact of several need not make it at the others.
            for road in 0..self.roads.len() {
                let impacts = self.roads[road].impacts_of(*owned);
                for impact in impacts.iter().filter(|_| impacts.len() > 1) {
                    let (trace, wrong) = self.again(road, &[MadeSlip::at(*owned, *impact)], &[]);
                    if !trace.slipped.is_empty() {
                        self.add_slip(slip, Some(*impact), road, trace, wrong);
                    }
                }
            }
        }
        singles
    }

    /// Adds what a slip by itself leads to, made at every impact or at one, where it does not lead there already.
    fn add_slip(
        &mut self,
        slip: usize,
        impact: Option<u8>,
        road: usize,
        trace: Trace,
        mut wrong: Vec<(usize, Values)>,
    ) {
        let lost = if Slip::all()[slip].1.condoned { Steps::default() } else { trace.slipped };
        let is_same = |way: &Way| match way.origin {
            Origin::Slips(other, None) | Origin::SlipAt(other, _) => other == slip,
            _ => false,
        };
        wrong.retain(|(answer, values)| !self.answers[*answer].has(values, |way| is_same(&self.ways[way])));
        let origin = impact.map_or(Origin::Slips(slip, None), |impact| Origin::SlipAt(slip, impact));
        self.add(Way { origin, road, trace, lost }, wrong.into_iter());
    }

    fn add_calculator(&mut self) {
        for (place, slip) in calculator::SLIPS.iter().enumerate() {
            let is_same = |way: &Way| matches!(way.origin, Origin::Calculator(other) if other == place);
            for road in 0..self.roads.len() {
                for entered in calculator::entered(slip, self.roads[road].known(), &self.letters) {
                    let (trace, mut wrong) = self.again(road, &[], &entered);
                    if road == 0 {
                        wrong.extend(self.again_backwards(road, &[], &entered));
                    }
                    wrong.retain(|(answer, values)| !self.answers[*answer].has(values, |way| is_same(&self.ways[way])));
                    let way = Way { origin: Origin::Calculator(place), road, trace, lost: Steps::default() };
                    self.add(way, wrong.into_iter());
                }
            }
        }
    }

    fn add_last_steps(&mut self) {
        for answer in 0..self.answers.len() {
            for (values, step) in self.answers[answer].last_steps(self.roads[0].known(), &self.answers) {
                let way =
                    Way { origin: Origin::LastStep(step), road: 0, trace: Trace::default(), lost: Steps::default() };
                self.add(way, std::iter::once((answer, values)));
            }
        }
    }

    /// Pairs of slips of different laws that both change an answer, likely ones first.
    fn add_pairs(&mut self, singles: &[Single]) {
        let all = Slip::all();
        let mut pairs: Vec<(&Single, &Single)> = Vec::new();
        for (place, one) in singles.iter().enumerate() {
            for two in &singles[place + 1..] {
                let same_law = all[one.slip].0 == all[two.slip].0;
                let apart = !same_law && !one.slipped.meets(two.slipped);
                if one.road == two.road && apart && one.changes & two.changes != 0 {
                    pairs.push((one, two));
                }
            }
        }
        pairs.sort_by_key(|(one, two)| (one.slip + two.slip, one.slip, one.road));
        pairs.dedup_by_key(|(one, two)| (one.slip, two.slip));
        for (one, two) in pairs.into_iter().take(MOST_PAIRS) {
            let slips = [one, two].map(|single| MadeSlip::everywhere(all[single.slip]));
            let (trace, mut wrong) = self.again(one.road, &slips, &[]);
            if self.backwards.as_ref().is_some_and(Backwards::is_quick) {
                wrong.extend(self.again_backwards(one.road, &slips, &[]));
            }
            wrong.retain(|(answer, values)| !self.answers[*answer].has(values, |way| self.ways[way].is_single()));
            let lost = [one, two].into_iter().filter(|single| !all[single.slip].1.condoned);
            let lost = lost.fold(Steps::default(), |lost, single| lost.and(single.slipped));
            let way = Way { origin: Origin::Slips(one.slip, Some(two.slip)), road: one.road, trace, lost };
            self.add(way, wrong.into_iter());
        }
    }
}

/// The derivation of what is asked on each road, each that is none of the others.
pub(super) fn roads<const N: usize>(given: &Known<Sample<N>>, asked: &[Quantity]) -> Vec<Carried<Sample<N>>> {
    let mut roads: Vec<Carried<Sample<N>>> = Vec::new();
    for road in Road::ALL {
        if roads.iter().any(|other| other.is_of(road, given, asked)) {
            continue;
        }
        let carried = Carried::on(road, given, asked);
        if roads.iter().all(|other| other.derivation() != carried.derivation()) {
            roads.push(carried);
        }
    }
    roads
}

/// The wrong values of the answers that a derivation has changed, each with the place of its answer.
fn look_for_wrong(answers: &[Answer]) -> impl Fn(&Carried<Sample>, Trace) -> (Trace, Vec<(usize, Values)>) {
    |carried, trace| {
        let is_changed = |answer: &Answer| answer.quantities().iter().any(|asked| carried.is_changed(*asked, trace));
        let changed = answers.iter().enumerate().filter(|(_, answer)| is_changed(answer));
        let values = changed.filter_map(|(place, answer)| Some((place, answer.values_in(carried.known())?)));
        (trace, values.filter(|(place, values)| !answers[*place].is_right(values)).collect())
    }
}
