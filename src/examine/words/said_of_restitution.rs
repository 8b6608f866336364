//! What the words say of coefficients of restitution: between whom, and how large.

use super::impacts::{impacts, ordinal};
use super::said::Seen;
use super::sentence::{Sentence, Token, is_one_of, says};
use crate::bank::{Answer, Find};
use crate::examine::Finding;
use crate::expr::{Expr, print, written};
use crate::mechanics::{Quantity, Sphere};
use crate::number::Value;
use crate::unit::Unit;

/// Words for what a sphere strikes beside other spheres.
const WALLS: [&str; 2] = ["wall", "walls"];

impl Seen<'_> {
    /// `The coefficient of restitution between A and B is 1/2, and that between B and the wall is 1/3`: each as the scene
    /// has it.
    pub(super) fn coefficients(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let Some(start) = sentence.iter().position(|token| is_one_of(token, &["restitution"])) else { return };
        if let Some(at) = self.gives_what_is_asked(&sentence[start..]) {
            let message = "the words give the coefficient of restitution, for which a part asks".to_owned();
            let help = "leave it out of the words, or give it as `e` in `[scene]` and ask for something else";
            findings.push(self.finding(message, &at, help));
            return;
        }
        for (place, token) in sentence.iter().enumerate().skip(start + 1) {
            let Token::Number(expr, Unit::None, lead) = token else { continue };
            // `Is {e} between the balls and {f} between *B* and the wall`
            let behind = between_whom(&sentence[place + 1..]);
            let is_next = behind.is_some() && is_one_of(&sentence[place - 1], &["and"]);
            let leads = is_next || is_one_of(&sentence[place - 1], &["is", "restitution"]);
            if matches!(expr, Expr::Relation(..) | Expr::Vector(..)) || !leads || self.names_what_is_found(expr) {
                continue;
            }
            let before = &sentence[start..place];
            let between = before.iter().rposition(|token| is_one_of(token, &["between"])).unwrap_or(0);
            let whom = behind.unwrap_or(&before[between..]);
            if let Some(strangers) = self.never_meet(whom) {
                let message = format!(
                    "the words give a coefficient of restitution between {strangers}, and in the scene they do not meet"
                );
                let help = "name in the words those that meet in `[scene]`, or let others meet there with `of`";
                findings.push(self.finding(message, lead, help));
                continue;
            }
            let of = of_another_wall(before).filter(|_| behind.is_none()).unwrap_or_else(|| whom.to_vec());
            let (Some(said), Some(has)) = (self.number(expr), self.coefficient_between(&of)) else {
                continue;
            };
            // Two that meet more than once have one coefficient, unless the words tell their impacts apart.
            let told = behind.unwrap_or(before);
            let named = Sphere::ALL.into_iter().filter(|sphere| told.contains(&Token::Sphere(*sphere))).count();
            let is_third = impacts(&self.question.scene).iter().any(|impact| impact.has(Sphere::C));
            let is_of_two = named == 2 || (named == 0 && !is_third && says(told, &["spheres", "them"]));
            let is_of_all = is_of_two && !says(sentence, &["first", "second", "third", "again"]);
            let other = has.iter().find(|has| !has.equals(&said));
            if let Some(other) = other.filter(|_| is_of_all || !has.iter().any(|has| has.equals(&said))) {
                let shown = print::plain(expr);
                let has = print::unicode(&written(other));
                let message =
                    format!("the words give the coefficient of restitution `{shown}` where the scene gives it {has}");
                let help = "name in the words the `e` that `[scene]` has for this impact, or change it there";
                findings.push(self.finding(message, &format!("{lead}{{{shown}"), help));
            }
        }
    }

    /// `*C* after its collision with *A*`, which never meet.
    pub(super) fn collisions(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        if says(sentence, &["no", "not", "never", "further"]) {
            return;
        }
        for (place, words) in sentence.windows(3).enumerate() {
            let [collision, with, Token::Sphere(other)] = words else { continue };
            let is_met = is_one_of(collision, &["collision", "impact"]) && is_one_of(with, &["with"]);
            let owner = sentence[..place].iter().rev().find(|token| matches!(token, Token::Sphere(_)));
            let Some(owner @ Token::Sphere(named)) = owner.filter(|_| is_met) else { continue };
            let Some(strangers) = self.never_meet(&[owner.clone(), words[2].clone()]).filter(|_| named != other) else {
                continue;
            };
            let message = format!("the words speak of a collision of {strangers}, and in the scene they do not meet");
            let help = "name in the words those that meet in `[scene]`, or let others meet there with `of`";
            findings.push(self.finding(message, &format!("with *{}*", other.name()), help));
        }
    }

    /// The words of a number that is given for the only coefficient there is, where a part asks for that.
    fn gives_what_is_asked(&self, words: &[Token]) -> Option<String> {
        let finds = |answer: &Answer| answer.find == Find::Quantity(Quantity::Restitution);
        let is_asked = self.question.parts.iter().flat_map(|part| &part.answers).any(finds);
        if !is_asked || !self.question.scene.then.is_empty() {
            return None;
        }
        words.windows(2).find_map(|pair| match pair {
            [is, Token::Word(typed)] if is_one_of(is, &["is"]) => {
                typed.parse::<f64>().ok().map(|_| format!("is {typed}"))
            }
            [is, Token::Number(expr, Unit::None, lead)]
                if is_one_of(is, &["is"]) && !self.names_what_is_found(expr) =>
            {
                self.number(expr).map(|_| lead.clone())
            }
            _ => None,
        })
    }

    /// `The coefficient of restitution is e. Find e`: a letter that the scene has nowhere is the name of what comes out.
    fn names_what_is_found(&self, expr: &Expr) -> bool {
        let Expr::Name(name) = expr else { return false };
        let scene = &self.question.scene;
        let finds = |answer: &Answer| answer.find == Find::Quantity(Quantity::Restitution);
        name.text == "e"
            && scene.e.is_none()
            && scene.then.is_empty()
            && scene.symbols.contains_key("e")
            && self.question.parts.iter().flat_map(|part| &part.answers).any(finds)
    }

    /// Two that are named, or one and a wall, and that do not meet in any impact.
    pub(super) fn never_meet(&self, words: &[Token]) -> Option<String> {
        let named: Vec<Sphere> =
            Sphere::ALL.into_iter().filter(|sphere| words.contains(&Token::Sphere(*sphere))).collect();
        let names = |sphere: &Sphere| format!("`*{}*`", sphere.name());
        let is_wall = says(words, &WALLS);
        let pair = match named.as_slice() {
            [one, other] if !is_wall => format!("{} and {}", names(one), names(other)),
            [one] if is_wall => format!("{} and a wall", names(one)),
            _ => return None,
        };
        let all = impacts(&self.question.scene);
        let meet = all.iter().any(|impact| impact.is_wall == is_wall && named.iter().all(|sphere| impact.has(*sphere)));
        (!meet).then_some(pair)
    }

    /// The coefficients of the impacts between those that are named; none if one of them is not known.
    fn coefficient_between(&self, words: &[Token]) -> Option<Vec<Value>> {
        let mut all = impacts(&self.question.scene);
        let is_named = |sphere: Sphere| words.contains(&Token::Sphere(sphere));
        let is_wall = says(words, &WALLS);
        // What is said of no one in particular is said of the only impact.
        if is_wall || says(words, &["spheres", "them"]) || Sphere::ALL.into_iter().any(is_named) {
            all.retain(|impact| impact.is_wall == is_wall);
        } else if all.len() > 1 {
            return None;
        }
        all.retain(|impact| Sphere::ALL.into_iter().all(|sphere| !is_named(sphere) || impact.has(sphere)));
        let nth = words.windows(2).find(|pair| is_one_of(&pair[1], &["wall"])).and_then(|pair| ordinal(&pair[0]));
        if let Some(nth) = nth.filter(|_| all.len() > 1) {
            all = all.into_iter().skip(nth).take(1).collect();
        }
        let of = |number| self.known.number(Quantity::Restitution.in_impact(number)?);
        all.iter().map(|impact| of(impact.number)).collect()
    }
}

/// The words behind a number that say between whom it is.
fn between_whom<'s, 't>(after: &'s [Token<'t>]) -> Option<&'s [Token<'t>]> {
    after.first().filter(|next| is_one_of(next, &["between"]))?;
    let end = after.iter().position(|token| matches!(token, Token::Number(..) | Token::Comma));
    Some(&after[..end.unwrap_or(after.len())])
}

/// `With the first wall it is {e} and with the second it is {f}`: what is said of the last number, and the wall that goes
/// without saying.
fn of_another_wall(before: &[Token]) -> Option<Vec<Token<'static>>> {
    let last = before.iter().rposition(|token| matches!(token, Token::Number(..)))?;
    let (told, own) = (&before[..last], &before[last + 1..]);
    let nth = own.iter().position(|token| ordinal(token).is_some() || is_one_of(token, &["other"]))?;
    let is_of_wall =
        says(told, &WALLS) && !says(own, &WALLS) && !own.iter().any(|token| matches!(token, Token::Sphere(_)));
    let word = match &own[nth] {
        Token::Word(word) if word == "other" => "second".to_owned(),
        Token::Word(word) => word.clone(),
        _ => return None,
    };
    is_of_wall.then(|| vec![Token::Word(word), Token::Word("wall".to_owned())])
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn each_coefficient_is_of_its_impact() {
        let table = [
            (
                "successive/three-in-a-line",
                "*C* immediately after they collide",
                "*C* after its collision with *A*",
                "collision of `*A*` and `*C*`",
            ),
            (
                "successive/three-in-a-line",
                "between *A* and *B* is {e}, and that between *B* and *C* is {f}",
                "is {e} between *A* and *B* and {f} between *B* and *C*",
                "",
            ),
            (
                "successive/three-in-a-line",
                "between *A* and *B* is {e}, and that between *B* and *C* is {f}",
                "is {f} between *A* and *B*, and {e} between *B* and *C*",
                "the coefficient of restitution `f` where the scene gives it",
            ),
            (
                "successive/struck-onto-a-wall",
                "between the spheres is {e}, and that between *B* and the wall is {f}",
                "is {f} between the spheres, and {e} between *B* and the wall",
                "the coefficient of restitution `f` where the scene gives it",
            ),
            (
                "walls/rebound-speed-and-direction",
                "is {e}.",
                "is {1 - e}.",
                "the coefficient of restitution `1 - e` where the scene gives it",
            ),
            (
                "successive/three-in-a-line",
                "*A* and *B* is {e}, and that between *B* and *C* is {f}",
                "*A* and *B* is {f}, and that between *B* and *C* is {e}",
                "the coefficient of restitution `f` where the scene gives it",
            ),
            (
                "successive/corner",
                "the first wall is {e}, and that between *A* and the second wall is {f}",
                "the second wall is {f}, and that between *A* and the first wall is {e}",
                "",
            ),
            (
                "successive/corner",
                "the first wall is {e}, and that between *A* and the second wall is {f}",
                "the first wall is {f}, and that between *A* and the second wall is {e}",
                "the coefficient of restitution `e` where the scene gives it",
            ),
            (
                "successive/corner",
                "between *A* and the first wall is {e}, and that between *A* and the second wall is {f}",
                "with the first wall is {e} and with the second it is {f}",
                "",
            ),
            (
                "successive/corner",
                "between *A* and the first wall is {e}, and that between *A* and the second wall is {f}",
                "with the second wall is {f} and with the first it is {f}",
                "the coefficient of restitution `f` where the scene gives it",
            ),
            (
                "direct/restitution-from-one-speed",
                "is {v m/s}.",
                "is {v m/s}. The coefficient of restitution is 1/2.",
                "give the coefficient of restitution, for which a part asks",
            ),
        ];
        assert_said(&table);
    }
}
