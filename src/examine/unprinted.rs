//! Values of parameters that no variant has, whole signs of them: nobody meets them, and every deal tries them.

use std::cmp::Ordering;
use std::collections::HashMap;

use super::finding::Finding;
use super::tally::Tally;
use crate::bank::{Domain, Question, Style};
use crate::expr::{Expr, number, print};

/// So many values are named.
const MOST_NAMED: usize = 4;

/// The values below nought, at nought or above it of a range that has others too, where no variant has any of them in any
/// style. Single values that a requirement turns away are no loss: a range is quickly written. And in a list each has been meant.
pub fn signs(question: &Question, tallies: &[Tally]) -> Vec<Finding> {
    // Of a style that was not examined to its end, or has no variant, nothing can be said.
    if tallies.iter().any(|tally| tally.census.examined < tally.census.size || tally.census.fit == 0) {
        return Vec::new();
    }
    let mut values: Vec<Values> = Vec::new();
    for (style, tally) in question.styles.iter().zip(tallies) {
        // The last parameter varies fastest.
        let mut stride = 1;
        for (name, domain) in style.parameters.iter().rev() {
            let place = values.iter().position(|known| known.name == *name).unwrap_or_else(|| {
                values.push(Values { name, style, all: Vec::new(), places: HashMap::new() });
                values.len() - 1
            });
            values[place].add(domain, stride, &tally.fit);
            stride *= domain.size();
        }
    }
    values.iter().flat_map(Values::findings).collect()
}

/// The values of a parameter in all styles.
struct Values<'q> {
    name: &'q str,
    /// A style that has it.
    style: &'q Style,
    /// Each with its sign, and whether some variant has it.
    all: Vec<(Expr, Ordering, bool)>,
    /// Where each stands among them: a range may have a hundred thousand.
    places: HashMap<Expr, usize>,
}

impl Values<'_> {
    /// Those of a style, of which these sets of numbers are its variants.
    fn add(&mut self, domain: &Domain, stride: u64, fit: &[u64]) {
        let written = if matches!(domain, Domain::Range { .. }) { domain.size() } else { 0 };
        for index in 0..written {
            let value = domain.value(index);
            let sign = number(&value, &|_| None).ok().and_then(|value| value.sign());
            let Some(sign) = sign.filter(|_| !self.places.contains_key(&value)) else { continue };
            self.places.insert(value.clone(), self.all.len());
            self.all.push((value, sign, false));
        }
        let mut is_printed = vec![false; domain.size() as usize];
        for set in fit {
            is_printed[(set / stride % domain.size()) as usize] = true;
        }
        for (index, _) in is_printed.into_iter().enumerate().filter(|(_, is_printed)| *is_printed) {
            if let Some(place) = self.places.get(&domain.value(index as u64)) {
                self.all[*place].2 = true;
            }
        }
    }

    fn findings(&self) -> Vec<Finding> {
        let signs = [Ordering::Less, Ordering::Equal, Ordering::Greater];
        let of_sign = |sign: Ordering| self.all.iter().filter(move |(_, own, _)| *own == sign);
        let is_idle = |sign: &Ordering| of_sign(*sign).count() > 0 && !of_sign(*sign).any(|(.., printed)| *printed);
        let idle = signs.into_iter().filter(is_idle);
        idle.map(|sign| {
            let all: Vec<String> = of_sign(sign).map(|(value, ..)| format!("`{}`", print::unicode(value))).collect();
            let more = all.len().saturating_sub(MOST_NAMED);
            let named = all[..all.len() - more].join(", ");
            let more = if more > 0 { format!(" and {more} more") } else { String::new() };
            let what = match sign {
                Ordering::Less => "below nought",
                Ordering::Equal => "at nought",
                Ordering::Greater => "above nought",
            };
            let message = format!("no variant has a value of `{}` {what}: {named}{more}", self.name);
            let help = "take them out of its values; or mend the requirement that turns them away";
            let key = Some((self.style.name, self.name.to_owned()));
            Finding { key, ..Finding::new(message, "", "never on paper").with_help(help).as_warning() }
        })
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::edited;

    #[test]
    fn values_of_a_sign_that_no_variant_has_are_told() {
        let told = |speeds: &str, is_fit: fn(i64) -> bool| {
            let speeds = format!("u  = \"{speeds}\"");
            let question = edited("successive/second-collision", &[("u  = \"2..12\"", &speeds)]);
            let tally = |style: &Style| {
                let speed = |index: &u64| {
                    let mut own = style.parameters_at(*index).into_iter();
                    let (_, speed) = own.find(|(name, _)| name == "u").unwrap();
                    is_fit(print::plain(&speed).parse().unwrap())
                };
                let mut tally = Tally::new(style.size());
                tally.census.examined = style.size();
                tally.fit = (0..style.size()).filter(speed).collect();
                tally.census.fit = tally.fit.len() as u64;
                tally
            };
            let tallies: Vec<Tally> = question.styles.iter().map(tally).collect();
            signs(&question, &tallies).into_iter().map(|finding| finding.message).collect::<String>()
        };
        assert_eq!(told("2..12", |_| true), "");
        assert_eq!(told("2..12", |u| u > 3), "");
        assert_eq!(told("-2..12", |u| u > -2 && u != 0), "no variant has a value of `u` at nought: `0`");
        assert_eq!(
            told("-6..2", |u| u > 0),
            "no variant has a value of `u` below nought: `−6`, `−5`, `−4`, `−3` and 2 moreno variant has a value of `u` at nought: `0`"
        );
    }
}
