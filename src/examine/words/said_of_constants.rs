//! Numbers that stand in the words as they are, without a name: does anything in the scene have them?

use std::cmp::Ordering;
use std::collections::BTreeSet;

use super::given::{names_in, names_of_scene, said_in};
use super::said::Seen;
use super::sentence::{Sentence, Token, is_one_of};
use crate::answer::Kind;
use crate::examine::Finding;
use crate::expr::{Expr, Relation, Turn, print, written};
use crate::number::Value;
use crate::unit::Unit;

impl Seen<'_> {
    /// A mass, speed or angle that the words give as a plain number, where no quantity of the scene has it: the number may
    /// be that of another condition, or one that was changed in the scene alone.
    pub(super) fn constants(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        for token in sentence {
            let Token::Number(expr, unit @ (Unit::Kilogram | Unit::MetrePerSecond | Unit::Degree), lead) = token else {
                continue;
            };
            let is_plain = expr.names().is_empty() && !matches!(expr, Expr::Vector(..));
            let Some(said) = self.number(expr).and_then(|value| value.to_f64()).filter(|_| is_plain) else { continue };
            // A right angle may stand in a condition as a scalar product.
            let is_right = *unit == Unit::Degree && said == 90.0 && !self.question.scene.conditions.is_empty();
            if !is_right && !self.stands_in_scene(expr) && !self.has(said, *unit) {
                let shown = format!("{} {}", print::plain(expr), unit.plain());
                let message = format!("the words give `{shown}`, and nothing in the scene has it");
                let help =
                    "say what the scene has, or give the number in `[scene]`: in a velocity, a mass or `conditions`";
                findings.push(self.finding(message, lead, help).as_warning());
            }
        }
    }

    /// Letters that the words place outside the range for which the scene declares them: `{k} is a negative constant`,
    /// `{e > 1}`.
    pub(super) fn declared(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let range = |name: &str| self.question.scene.symbols.get(name).map(String::as_str);
        for (place, token) in sentence.iter().enumerate() {
            let Token::Number(expr, Unit::None, lead) = token else { continue };
            if let (Expr::Name(name), Some(said)) = (expr, compared(&sentence[place + 1..])) {
                self.beside_a_bound(&name.text, expr, said, findings);
                continue;
            }
            let (name, is_outside) = match expr {
                Expr::Name(name) => {
                    let next = sentence[place + 1..].iter().take(3);
                    (
                        name,
                        range(&name.text) != Some("real")
                            && next.into_iter().any(|token| is_one_of(token, &["negative"])),
                    )
                }
                Expr::Relation(left, relation, right) => {
                    let (Expr::Name(name), Some(bound)) =
                        (&**left, self.number(right).and_then(|value| value.to_f64()))
                    else {
                        continue;
                    };
                    let is_below = matches!(relation, Relation::Less | Relation::LessOrEqual) && bound <= 0.0;
                    let is_above = matches!(relation, Relation::Greater | Relation::GreaterOrEqual) && bound >= 1.0;
                    if let Some(has) = self.excluded(&name.text, *relation, bound) {
                        let message = format!("the words say that `{}`, and it is {has}", print::plain(expr));
                        let help = "mend the bound in the words, or require numbers for which it is so";
                        findings.push(self.finding(message, &format!("{lead}{{{}", name.text), help));
                        continue;
                    }
                    let is_outside = match range(&name.text) {
                        Some("unit") => is_below || is_above,
                        Some("positive" | "acute") => is_below,
                        _ => false,
                    };
                    (name, is_outside)
                }
                _ => continue,
            };
            if let (true, Some(range)) = (is_outside, range(&name.text)) {
                let said = match expr {
                    Expr::Name(_) => format!("{} is negative", name.text),
                    relation => print::plain(relation),
                };
                let message = format!("the words say that `{said}`, and the scene declares it `{range}`");
                let help = format!("say what `[scene.symbols]` has for `{}`, or declare it otherwise", name.text);
                findings.push(self.finding(message, lead, &help));
            }
        }
    }

    /// `{e}, which is greater than 1`, where it cannot be, or is not.
    fn beside_a_bound(&self, name: &str, expr: &Expr, (side, bound): (Ordering, f64), findings: &mut Vec<Finding>) {
        let has = match self.question.scene.symbols.get(name).map(String::as_str) {
            Some(range @ ("unit" | "positive" | "acute")) => {
                let is_outside = if side.is_lt() { bound <= 0.0 } else { range == "unit" && bound >= 1.0 };
                is_outside.then(|| format!("the scene declares it `{range}`"))
            }
            Some(_) => None,
            None => {
                let value = self.number(expr).filter(|value| value.to_f64().is_some());
                let is_so = |value: &Value| value.to_f64().and_then(|value| value.partial_cmp(&bound)) == Some(side);
                value.filter(|value| !is_so(value)).map(|value| format!("it is {}", print::unicode(&written(&value))))
            }
        };
        let Some(has) = has else { return };
        let how = if side.is_lt() { "less" } else { "greater" };
        let message = format!("the words say that `{name}` is {how} than {bound}, and {has}");
        let help = format!("say what the scene has for `{name}`, or mend it there");
        findings.push(self.finding(message, &format!("{how} than"), &help));
    }

    /// What is found for a letter, one value or a range of them, where none of it is on this side of a bound.
    fn excluded(&self, name: &str, relation: Relation, bound: f64) -> Option<String> {
        let solution = &self.variant.solution;
        let (side, may_be_equal) = match relation {
            Relation::Less => (Ordering::Less, false),
            Relation::LessOrEqual => (Ordering::Less, true),
            Relation::Greater => (Ordering::Greater, false),
            Relation::GreaterOrEqual => (Ordering::Greater, true),
            _ => return None,
        };
        let is_beyond = |value: &Value, is_reached: bool| {
            let place = value.to_f64()?.partial_cmp(&bound)?;
            Some(place != side && !(place.is_eq() && may_be_equal && is_reached))
        };
        if let Some((_, value)) = solution.found().iter().find(|(letter, _)| letter.name() == name) {
            return is_beyond(value, true)?.then(|| print::unicode(&written(value)));
        }
        let values = solution.range().filter(|values| values.letter.name() == name)?;
        let nearest = if side.is_lt() { &values.span.low } else { &values.span.high };
        let end = nearest.as_ref()?;
        is_beyond(&end.value, end.included)?.then(|| print::unicode(&values.written()))
    }

    /// Letters that an answer has, and that the words never give.
    pub(super) fn letters_unsaid(&self, findings: &mut Vec<Finding>) {
        let scene = &self.question.scene;
        let said = said_in(self.question, self.style);
        let answers =
            self.question.parts.iter().flat_map(|part| &part.answers).filter(|answer| answer.kind != Kind::Shown);
        let quantities = answers.flat_map(|answer| answer.find.quantities());
        let values = quantities.filter_map(|quantity| self.variant.solution.number(quantity));
        let letters: BTreeSet<String> =
            values.flat_map(|value| value.letters()).map(|letter| letter.name().to_owned()).collect();
        let is_unsaid = |letter: &&String| !said.contains(*letter) && !scene.unknowns.contains(letter);
        for letter in letters.iter().filter(is_unsaid) {
            // The sine of an angle in degrees has a name of its own.
            let Some(range) = scene.symbols.get(letter) else { continue };
            let message = format!("an answer has the letter `{letter}`, and the words never give it");
            let at = format!("{letter} = \"{range}\"");
            let help = format!("write `{{{letter}}}` into the stem, with its braces, where it is given");
            findings.push(self.finding(message, &at, &help));
        }
    }

    /// Do the scene and what is derived for it hold the same digits?
    fn stands_in_scene(&self, expr: &Expr) -> bool {
        let mut there = names_of_scene(self.question);
        there.extend(self.style.lets.iter().flat_map(|(_, formula)| names_in(&print::plain(formula))));
        names_in(&print::plain(expr)).is_subset(&there)
    }

    /// Does a quantity of the unit have this value? An angle may be measured from either end of a line, or across it.
    fn has(&self, said: f64, unit: Unit) -> bool {
        let solution = &self.variant.solution;
        let quantities = solution.scene().quantities().into_iter().filter(|quantity| quantity.unit() == unit);
        let mut values = quantities.filter_map(|quantity| match unit {
            Unit::Degree => Turn::of(solution.angle(quantity)?).to_f64(),
            _ => solution.number(quantity)?.to_f64(),
        });
        let turned = if unit == Unit::Degree { vec![said, 180.0 - said, 90.0 - said] } else { vec![said] };
        values.any(|value| turned.iter().any(|said| (value.abs() - said).abs() < 1e-6))
    }
}

/// What is said of a letter right behind it: `is greater than 1`, `, which is less than 0`.
fn compared(after: &[Token]) -> Option<(Ordering, f64)> {
    const BETWEEN: [&str; 8] = ["which", "where", "that", "is", "are", "a", "constant", "number"];
    let mut rest = after.iter().skip_while(|token| **token == Token::Comma || is_one_of(token, &BETWEEN));
    let side = match rest.next()? {
        token if is_one_of(token, &["greater", "more", "larger"]) => Ordering::Greater,
        token if is_one_of(token, &["less", "smaller"]) => Ordering::Less,
        _ => return None,
    };
    rest.next().filter(|than| is_one_of(than, &["than"]))?;
    let bound = match rest.next()? {
        Token::Word(word) => word.parse().ok()?,
        Token::Number(Expr::Number(number), Unit::None, _) => number.to_f64(),
        _ => return None,
    };
    Some((side, bound))
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn numbers_and_bounds_of_the_words_are_in_the_scene() {
        let table = [
            (
                "rest/speeds-and-directions",
                "have equal radii",
                "have radius {5} and one has mass twice that of {4}",
                "",
            ),
            (
                "rest/speeds-and-directions",
                "is {e}.",
                "is {e}. The path of *A* is turned through an angle and then makes another of {60 deg} with it.",
                "the words give `60 deg`, and nothing in the scene has it",
            ),
            (
                "ranges/direction-reversed",
                "spheres is {e}.",
                "spheres is {e}, where {e < 1/20}.",
                "say that `e < 1/20`, and it is",
            ),
            ("ranges/direction-reversed", "spheres is {e}.", "spheres is {e}, where {e > 1/20}.", ""),
            (
                "walls/turned-through-a-right-angle",
                "a right angle.\n",
                "a right angle, where {e < 1/20}.\n",
                "`e < 1/20`, and it is",
            ),
            ("deflection/equal-masses", "{e < 1}", "{e > 1}", "say that `e > 1`, and the scene declares it `unit`"),
            ("vector-impulse/size-of-the-impulse", "is a positive constant", "is a negative constant", "k is negative"),
            (
                "walls/turned-through-a-right-angle",
                "through a right angle",
                "by {60 deg}",
                "the words give `60 deg`, and nothing in the scene has it",
            ),
        ];
        assert_said(&table);
    }
}
