//! All sets of numbers of a style examined, and how many each requirement turns away.

use std::collections::BTreeMap;
use std::ops::Range;

use super::form::Form;
use super::numbers::{Further, Numbers};
use super::processors::on_all_processors;
use super::sieve::Sieve;
use super::variant::{Unfit, Variant};
use crate::bank::{Question, Style};

/// What became of every set of numbers of a question in a style.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Census {
    /// How many sets there are.
    pub size: u64,
    /// How many of them have been examined: all, unless there are more than [`MOST_SETS`].
    pub examined: u64,
    /// How many are fit for print.
    pub fit: u64,
    /// How many each reason turned away, in the order in which reasons are examined.
    pub unfit: BTreeMap<Unfit, u64>,
    /// How many of these nothing else would have turned away. An estimate, where not all of them are asked:
    /// [`Census::asked`].
    pub alone: BTreeMap<Unfit, u64>,
    /// Of how many that are turned away by their givens one is asked whether anything else would have turned it away;
    /// nought if nobody is asked.
    pub one_in: u64,
    /// The first set that each reason turned away.
    pub first: BTreeMap<Unfit, u64>,
    /// In how many variants each answer, in the order of the question, has which form.
    pub forms: Vec<BTreeMap<Form, u64>>,
}

/// The most sets of numbers of one style that are examined. Nobody waits for more; of a style that has more the first are.
pub const MOST_SETS: u64 = 500_000;

/// The most sets of a style that are solved only because, turned away by their givens, they are asked for a second reason:
/// that takes longer than all the rest, and whoever thinks about a requirement wants to know whether it costs ten variants
/// or a thousand. Which ones follows from their index, so that every run says the same.
const MOST_ASKED: u64 = 1024;

/// Out of how many sets something was counted: `144`, or `the first 500000 of 900000`.
pub fn out_of(examined: u64, size: u64) -> String {
    if examined < size { format!("the first {examined} of {size}") } else { size.to_string() }
}

impl Census {
    /// The funnel: each reason in words and how many sets it turned away.
    pub fn funnel(&self, question: &Question, style: &Style) -> Vec<(String, u64)> {
        self.unfit.iter().map(|(reason, count)| (in_words(reason, question, style), *count)).collect()
    }

    /// Where nothing is fit for print: the requirement that turns away the last, and how many.
    pub fn last_requirement<'s>(&self, style: &'s Style) -> Option<(&'s str, u64)> {
        let (reason, count) = self.unfit.last_key_value().filter(|_| self.fit == 0)?;
        Some((style.require.get(reason.requirement()?)?.text.as_str(), *count))
    }

    /// Of a style with so many sets; nobody is asked for a second reason.
    pub fn new(size: u64) -> Census {
        Census { size, ..Census::default() }
    }

    /// The same, and of those turned away it is to be found how many nothing else would have turned away.
    pub fn asking(size: u64) -> Census {
        Census { one_in: size.div_ceil(MOST_ASKED).max(1), ..Census::new(size) }
    }

    /// Of how many that a reason turned away one was asked for a second one. What has been solved is asked in any case.
    pub fn asked(&self, reason: &Unfit) -> u64 {
        if matches!(reason, Unfit::Givens(_)) { self.one_in } else { self.one_in.min(1) }
    }

    /// Which second reasons are of interest? Of what the givens turn away, those of sets that lie evenly: by the fractional
    /// parts of multiples of the golden ratio.
    fn further(&self, index: u64) -> Further {
        let spread = index.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        match self.one_in {
            0 => Further::Never,
            one_in if spread <= u64::MAX / one_in => Further::Always,
            _ => Further::OfResults,
        }
    }

    /// Examines one set and counts it; the variant of the sieve's style, if it is fit for print.
    pub fn examine(&mut self, sieve: &Sieve, numbers: &Numbers) -> Option<Variant> {
        self.examined += 1;
        let index = numbers.index;
        match numbers.examine(sieve, self.further(index)) {
            Ok(variant) => {
                self.count_fit(sieve.question, &variant);
                Some(variant)
            }
            Err((reason, is_alone)) => {
                if is_alone {
                    *self.alone.entry(reason.clone()).or_default() += self.asked(&reason);
                }
                let first = self.first.entry(reason.clone()).or_insert(index);
                *first = index.min(*first);
                *self.unfit.entry(reason).or_default() += 1;
                None
            }
        }
    }

    fn count_fit(&mut self, question: &Question, variant: &Variant) {
        self.fit += 1;
        let answers = question.parts.iter().flat_map(|part| &part.answers);
        for (place, answer) in answers.enumerate() {
            if self.forms.len() <= place {
                self.forms.resize_with(place + 1, BTreeMap::new);
            }
            if let Some(form) = Form::of_answer(answer, &variant.solution) {
                *self.forms[place].entry(form).or_default() += 1;
            }
        }
    }

    /// Adds what was counted of other sets of the same style.
    pub fn add(&mut self, other: Census) {
        self.examined += other.examined;
        self.fit += other.fit;
        add(&mut self.unfit, other.unfit);
        add(&mut self.alone, other.alone);
        for (reason, index) in other.first {
            let first = self.first.entry(reason).or_insert(index);
            *first = index.min(*first);
        }
        self.forms.resize_with(self.forms.len().max(other.forms.len()), BTreeMap::new);
        for (own, other) in self.forms.iter_mut().zip(other.forms) {
            add(own, other);
        }
    }
}

fn add<K: Ord>(own: &mut BTreeMap<K, u64>, other: BTreeMap<K, u64>) {
    for (key, count) in other {
        *own.entry(key).or_default() += count;
    }
}

impl Unfit {
    /// The place of the requirement that turned the set away, if one did.
    pub fn requirement(&self) -> Option<usize> {
        match self {
            Unfit::Givens(place) | Unfit::Results(place) => Some(*place),
            _ => None,
        }
    }
}

/// The requirement as it was written.
fn requirement(reason: &Unfit, style: &Style) -> String {
    let found = reason.requirement().and_then(|place| style.require.get(place));
    found.map_or_else(String::new, |requirement| requirement.text.clone())
}

fn in_words(reason: &Unfit, question: &Question, style: &Style) -> String {
    match reason {
        Unfit::Givens(_) | Unfit::Results(_) => format!("not `{}`", requirement(reason, style)),
        Unfit::NoValue => "a formula has no value".to_owned(),
        Unfit::Impossible => "cannot happen".to_owned(),
        Unfit::Underdetermined => "something is left open".to_owned(),
        Unfit::BeyondMethods => "beyond exam methods".to_owned(),
        Unfit::Tie(place) => {
            let find = question.parts.iter().flat_map(|part| &part.answers).nth(*place);
            let names = find.map_or(Vec::new(), |answer| answer.find.quantities());
            let names: Vec<String> = names.iter().map(|quantity| format!("`{quantity}`")).collect();
            format!("{} too near a tie to be rounded", names.join(", "))
        }
    }
}

/// How many sets a thread takes at a time.
const PORTION: u64 = 64;

/// The indices of a style with so many sets, or of the first [`MOST_SETS`], in portions each of which one thread examines.
pub fn portions(size: u64) -> impl Iterator<Item = Range<u64>> {
    let most = size.min(MOST_SETS);
    (0..most.div_ceil(PORTION)).map(move |nth| nth * PORTION..most.min((nth + 1) * PORTION))
}

/// Examines every set of numbers of a style, or the first [`MOST_SETS`], on all processors.
///
/// `visit` sees every variant that is fit, in no particular order, and `progress` is told now and then how many
/// sets have been examined.
pub fn enumerate(
    question: &Question,
    style: &Style,
    visit: &(dyn Fn(Variant) + Sync),
    progress: &(dyn Fn(u64) + Sync),
) -> Census {
    let size = style.size();
    let sieve = Sieve::new(question, style);
    let examine = |census: &mut Census, indices: &Range<u64>| {
        for index in indices.clone() {
            census.examine(&sieve, &Numbers::new(&sieve, index)).into_iter().for_each(visit);
        }
        progress(indices.end);
    };
    let all: Vec<Range<u64>> = portions(size).collect();
    let mut total = Census::new(size);
    on_all_processors(&all, &|| Census::new(size), &examine).into_iter().for_each(|census| total.add(census));
    total
}
