//! What the words say that happens where only a condition of the scene decides it: who meets again, which way a component
//! points, who goes on in the old direction, whose speed grows.

use std::cmp::Ordering;

use super::impacts::{impacts, ordinal};
use super::said::{Seen, moment};
use super::said_of_walls::STRUCK;
use super::sentence::{Sentence, Token, is_one_of, says, subject};
use crate::examine::Finding;
use crate::expr::{Relation, print};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

/// Words for what a sphere had before the impact.
const OLD: [&str; 6] = ["old", "original", "previous", "initial", "former", "earlier"];

/// One thing to try where the words and the scene disagree on what happens.
pub(super) const MEND: &str = "mend the `conditions` or velocities of `[scene]`, or say what happens";

impl Seen<'_> {
    /// Two spheres that are said to meet again, or not to, where a condition compares their velocities: the one ahead is
    /// slower than the one behind, or it is not.
    pub(super) fn meeting_again(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let again = |at: &usize| {
            is_one_of(&sentence[*at], &["again", "further", "more", "another"]) || self.is_next(&sentence[*at..])
        };
        let counted = (0..sentence.len()).find_map(|at| Some((at, self.is_last(&sentence[at..])?)));
        let Some(at) = (0..sentence.len()).find(again).or(counted.map(|(at, _)| at)) else { return };
        let meets =
            ["strike", "strikes", "collide", "collides", "hit", "hits", "meet", "meets", "collision", "collisions"];
        if !says(sentence, &meets) {
            return;
        }
        let is_denied = counted.map_or_else(|| says(sentence, &["not", "no", "never"]), |(_, is_last)| is_last);
        let sphere = |quantity: Quantity| match quantity.of_its_impact() {
            Quantity::Velocity(sphere, Moment::After, Axis::N | Axis::X) => Some(sphere),
            _ => None,
        };
        for condition in &self.variant.scene.conditions {
            let of = |side| print::plain(side).parse::<Quantity>().ok().and_then(sphere);
            let (Some(left), Some(right)) = (of(&condition.left), of(&condition.right)) else { continue };
            let is_slower = match condition.relation {
                Relation::Less | Relation::LessOrEqual => true,
                Relation::Greater | Relation::GreaterOrEqual => false,
                _ => continue,
            };
            // The positive direction is from A towards the others.
            let (ahead, behind) = if left > right { (left, right) } else { (right, left) };
            let is_met = if left == ahead { is_slower } else { !is_slower };
            // `There is no second collision` is said of them too.
            let is_named = |sphere: Sphere| sentence.contains(&Token::Sphere(sphere));
            let names_both = [ahead, behind].into_iter().all(is_named) || !Sphere::ALL.into_iter().any(is_named);
            let is_strict = matches!(condition.relation, Relation::Less | Relation::Greater);
            if left != right && names_both && is_met != is_denied && is_strict == is_denied {
                let (said, other) = if is_denied { ("never meet", "nor") } else { ("meet", "and never") };
                let message = format!(
                    "the words say that `*{}*` and `*{}*` {said} again, {other} do they where their velocities are equal",
                    behind.name(),
                    ahead.name()
                );
                let relation = if is_denied { "`<=` or `>=`" } else { "`<` or `>`" };
                let Token::Word(word) = &sentence[at] else { continue };
                let help = format!("compare them by {relation} in `conditions`");
                let found = self.finding(message, word, &help);
                findings.push(if is_denied { found.as_warning() } else { found });
            }
            if left != right && names_both && is_met == is_denied {
                let (said, other) = if is_denied { ("do not meet", "meet") } else { ("meet", "do not meet") };
                let message = format!(
                    "the words say that `*{}*` and `*{}*` {said} again, and with the conditions of the scene they {other}",
                    behind.name(),
                    ahead.name()
                );
                let Token::Word(word) = &sentence[at] else { continue };
                findings.push(self.finding(message, word, MEND));
            }
        }
    }

    /// Two that are said to meet `again`, or not to, and in the scene have never met.
    pub(super) fn met_before(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const DENIED: [&str; 9] = ["does", "do", "will", "not", "never", "then", "later", "both", "must"];
        let Some(at) = sentence.iter().position(|token| is_one_of(token, &["again"])) else { return };
        let before: Vec<&Token> = sentence[..at].iter().filter(|token| !is_one_of(token, &DENIED)).collect();
        let meets = |token: &Token| {
            is_one_of(token, &["strike", "strikes", "collide", "collides", "hit", "hits", "meet", "meets"])
        };
        let pair = match before.as_slice() {
            [.., Token::Sphere(one), meets_it, Token::Sphere(other)] if meets(meets_it) => [*one, *other],
            [.., Token::Sphere(one), meets_it, with, Token::Sphere(other)]
                if meets(meets_it) && is_one_of(with, &["with", "into"]) =>
            {
                [*one, *other]
            }
            [.., Token::Sphere(one), and, Token::Sphere(other), meet] if is_one_of(and, &["and"]) && meets(meet) => {
                [*one, *other]
            }
            _ => return,
        };
        let have_met = impacts(&self.question.scene).iter().any(|impact| pair.iter().all(|sphere| impact.has(*sphere)));
        if !have_met && pair[0] != pair[1] {
            let [one, other] = pair.map(Sphere::name);
            let message = format!(
                "the words say that `*{one}*` and `*{other}*` meet again, and in the scene they have never met"
            );
            let help = "name those that have met in `[scene]`, or leave out `again`";
            findings.push(self.finding(message, "again", help));
        }
    }

    /// How many impacts the scene has, and how many of them are between spheres.
    fn impacts_counted(&self) -> [usize; 2] {
        let all = impacts(&self.question.scene);
        [all.len(), all.iter().filter(|impact| !impact.is_wall).count()]
    }

    /// `A third collision`, where the scene has two; a second one is always another between spheres.
    fn is_next(&self, words: &[Token]) -> bool {
        let [nth, of, ..] = words else { return false };
        let is_nth = |nth| nth == 1 || self.impacts_counted().contains(&nth);
        ordinal(nth).is_some_and(is_nth) && is_one_of(of, &["collision", "impact", "time"])
    }

    /// Whether `exactly two collisions` are all that the scene has; `exactly three` are one more.
    fn is_last(&self, words: &[Token]) -> Option<bool> {
        let [exactly, count, of, ..] = words else { return None };
        let is_count = is_one_of(exactly, &["exactly", "only"]) && is_one_of(of, &["collisions", "impacts"]);
        let nth =
            ["one", "two", "three", "four"].iter().position(|word| is_one_of(count, &[word])).filter(|_| is_count)?;
        let scene = self.impacts_counted();
        if scene.contains(&(nth + 1)) { Some(true) } else { scene.contains(&nth).then_some(false) }
    }

    /// `Taking the direction of motion of A before it as positive`: the way from A towards the others is positive in answers.
    pub(super) fn positive(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let at = |word: &str| sentence.iter().position(|token| is_one_of(token, &[word]));
        let (Some(start), Some(end)) = (at("taking"), at("positive")) else { return };
        let way = sentence.get(start..end).unwrap_or_default();
        let spheres: Vec<&Token> = way.iter().filter(|token| matches!(token, Token::Sphere(_))).collect();
        let [Token::Sphere(sphere)] = spheres.as_slice() else { return };
        let moves =
            self.known.number(Quantity::Velocity(*sphere, Moment::Before, Axis::N)).and_then(|along| along.sign());
        let wanted = if says(way, &["opposite"]) { Ordering::Less } else { Ordering::Greater };
        let is_of_motion = says(way, &["motion"]) && !says(way, &["after", "towards", "away"]);
        if is_of_motion && self.question.scene.then.is_empty() && moves == Some(wanted.reverse()) {
            let message = "the words take the other direction as positive than the answers have".to_owned();
            let help = "say that the direction of motion of *A* before the impact is positive";
            findings.push(self.finding(message, "taking the direction", help));
        }
    }

    /// A component along the line of centres that is said to be directed towards the other sphere, or away from it.
    pub(super) fn directed(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let Some(at) = sentence.iter().position(|token| is_one_of(token, &["directed"])) else { return };
        let (way, other) = match &sentence[at + 1..] {
            [Token::Word(to), Token::Sphere(other), ..] if to == "towards" => (Ordering::Greater, *other),
            [Token::Word(away), Token::Word(_), Token::Sphere(other), ..] if away == "away" => (Ordering::Less, *other),
            _ => return,
        };
        let Some(Token::Sphere(own)) = sentence[..at].iter().rev().find(|token| matches!(token, Token::Sphere(_)))
        else {
            return;
        };
        if *own == other || !self.question.scene.then.is_empty() || moment(sentence, at) == Moment::Before {
            return;
        }
        let known = self.known.number(Quantity::Velocity(*own, Moment::After, Axis::N)).and_then(|along| along.sign());
        let Some(has) = known.or_else(|| self.required(*own)).filter(|has| has.is_ne()) else { return };
        // The line of centres runs from A to B.
        let wanted = if *own < other { way } else { way.reverse() };
        if has != wanted {
            let said = if way.is_gt() { "towards" } else { "away from" };
            let (own, other) = (own.name(), other.name());
            let message = format!("the words say that `*{own}*` then moves {said} *{other}*, and it is not so");
            findings.push(self.finding(
                message,
                &format!("directed {}", said.split(' ').next().unwrap_or_default()),
                MEND,
            ));
        }
    }

    /// A sphere that goes on in the same direction, or in the opposite one, after a direct impact.
    pub(super) fn same_way(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let at = (1..sentence.len()).find(|at| {
            is_one_of(&sentence[*at], &["direction", "directions"])
                && is_one_of(&sentence[at - 1], &["same", "opposite"])
        });
        let goes_on = says(sentence, &["continues", "carries", "keeps"]);
        let Some(at) = at.filter(|at| goes_on || moment(sentence, *at) == Moment::After) else { return };
        let Token::Word(said) = &sentence[at - 1] else { return };
        let is_back = said == "opposite";
        let Some(sphere) = subject(&sentence[..at - 1]) else {
            self.same_way_as_each_other(&sentence[..at - 1], &sentence[at + 1..], said, findings);
            return;
        };
        // The direction of another, or that opposite to its own, is told in other words.
        let is_plain =
            !sentence[at + 1..].iter().take(2).any(|token| is_one_of(token, &["to", "as", "of", "opposite"]));
        if is_plain && self.question.scene.then.is_empty() && self.turns_round(sphere) == Some(!is_back) {
            let message =
                format!("the words say that `*{}*` moves in the {said} direction, and it is not so", sphere.name());
            findings.push(self.finding(message, &format!("{said} direction"), MEND));
        }
    }

    /// Both spheres move in one direction after a direct impact, or in opposite ones.
    fn same_way_as_each_other(&self, before: &[Token], after: &[Token], said: &str, findings: &mut Vec<Finding>) {
        let are_both = says(before, &["both", "they", "spheres", "two"])
            || Sphere::BOTH.into_iter().all(|sphere| before.contains(&Token::Sphere(sphere)));
        let is_old = says(after, &OLD) || after.first().is_some_and(|next| is_one_of(next, &["as", "to", "of"]));
        if !are_both || is_old || !self.is_direct() || !self.question.scene.then.is_empty() || self.is_alone() {
            return;
        }
        let way = |sphere: Sphere| {
            let along = self.known.number(Quantity::Velocity(sphere, Moment::After, Axis::N));
            along.and_then(|along| along.sign()).or_else(|| self.required(sphere))
        };
        let (Some(a), Some(b)) = (way(Sphere::A), way(Sphere::B)) else { return };
        let is_so = if said == "same" { a == b } else { a == b.reverse() };
        if a.is_ne() && b.is_ne() && !is_so {
            let plural = if said == "same" { "the same direction" } else { "opposite directions" };
            let message = format!("the words say that the spheres then move in {plural}, and it is not so");
            findings.push(self.finding(message, &format!("{said} direction"), MEND));
        }
    }

    /// Spheres that are said to move in their old direction after the impact, or against it: `in the direction opposite to
    /// its old one`, `in its original direction`, `in the same direction as before`.
    pub(super) fn old_way(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        // Such sentences speak of another direction as well.
        const OTHERWISE: [&str; 15] = [
            "not",
            "no",
            "neither",
            "component",
            "components",
            "angle",
            "angles",
            "perpendicular",
            "parallel",
            "turned",
            "deflected",
            "through",
            "reversed",
            "changed",
            "unchanged",
        ];
        let Some(at) = sentence.iter().position(|token| is_one_of(token, &["direction", "directions"])) else { return };
        let near = &sentence[at.saturating_sub(4)..sentence.len().min(at + 9)];
        let is_as_before = near.windows(2).any(|pair| is_one_of(&pair[0], &["as"]) && is_one_of(&pair[1], &["before"]))
            || near.windows(4).any(was_moving);
        let is_other = says(sentence, &OTHERWISE);
        let is_kept = keeps_its(&sentence[..at]);
        let is_after = moment(sentence, at) == Moment::After || (is_kept && says(&sentence[..at], &STRUCK));
        let is_old = is_as_before || is_kept || says(near, &OLD);
        if is_other || !is_after || !is_old || !self.question.scene.then.is_empty() {
            return;
        }
        let is_back = says(near, &["opposite", "reverse", "against"]);
        let of_both = says(&sentence[..at], &["each", "both", "they", "spheres"]) && !self.is_alone();
        // `After they collide, *A* moves`: of *A* alone.
        let of: Vec<Sphere> = match subject(&sentence[..at]) {
            None if of_both => Sphere::BOTH.to_vec(),
            one => one.into_iter().collect(),
        };
        if let Some(sphere) = of.into_iter().find(|sphere| self.goes_on(*sphere, is_back) == Some(false)) {
            let way = if is_back { "against its old direction" } else { "in its old direction" };
            let message = format!("the words say that `*{}*` then moves {way}, and it is not so", sphere.name());
            let words = sentence[at..].iter().map_while(|token| match token {
                Token::Word(word) => Some(word.as_str()),
                _ => None,
            });
            findings.push(self.finding(message, &words.take(3).collect::<Vec<_>>().join(" "), MEND));
        }
    }

    /// A sphere that is said to move at right angles to its old direction after the impact.
    pub(super) fn across(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const PATHS: [&str; 5] = ["direction", "path", "motion", "course", "line"];
        let is_old = |words: &[Token]| says(words, &OLD) && says(words, &PATHS);
        let at = (1..sentence.len()).find(|at| {
            let is_across = is_one_of(&sentence[*at], &["perpendicular"])
                || (is_one_of(&sentence[*at], &["angles"]) && is_one_of(&sentence[at - 1], &["right"]));
            let after = &sentence[at + 1..sentence.len().min(at + 6)];
            is_across && after.first().is_some_and(|to| is_one_of(to, &["to"])) && is_old(after)
        });
        let Some(at) = at.filter(|at| moment(sentence, *at) == Moment::After) else { return };
        if says(sentence, &["not", "no", "component", "components"]) || !self.question.scene.then.is_empty() {
            return;
        }
        let Some(sphere) = subject(&sentence[..at]).or(self.is_alone().then_some(Sphere::A)) else { return };
        let dot = self.products(sphere).and_then(|(dot, _)| dot.sign());
        if dot.is_some_and(|dot| dot.is_ne()) {
            let name = sphere.name();
            let message =
                format!("the words say that `*{name}*` then moves across its old direction, and it is not so");
            let Token::Word(word) = &sentence[at] else { return };
            findings.push(self.finding(message, word, MEND));
        }
    }

    /// A speed that is said to increase or to decrease.
    pub(super) fn growing(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const MORE: [&str; 4] = ["increases", "increased", "greater", "grows"];
        const LESS: [&str; 4] = ["decreases", "decreased", "reduced", "falls"];
        for (at, four) in sentence.windows(3).enumerate() {
            let [speed, of, Token::Sphere(sphere)] = four else { continue };
            if !is_one_of(speed, &["speed"]) || !is_one_of(of, &["of"]) {
                continue;
            }
            let next = sentence[at + 3..].iter().find(|token| !is_one_of(token, &["is", "was", "then"]));
            let wanted = match next {
                Some(token) if is_one_of(token, &MORE) => Ordering::Greater,
                Some(token) if is_one_of(token, &LESS) => Ordering::Less,
                _ => continue,
            };
            let has = |moment| self.known.number(Quantity::Speed(*sphere, moment)).map(|speed| &speed * &speed);
            let (Some(before), Some(after), Some(Token::Word(word))) = (has(Moment::Before), has(Moment::After), next)
            else {
                continue;
            };
            let is_other = (&after - &before).sign().is_some_and(|sign| sign != wanted);
            if is_other && self.question.scene.then.is_empty() && !says(sentence, &["not", "than"]) {
                let message = format!("the words say `{word}` of the speed of `*{}*`, and it is not so", sphere.name());
                findings.push(self.finding(message, word, MEND));
            }
        }
    }
}

/// `In which it was moving`
fn was_moving(words: &[Token]) -> bool {
    let [which, it, was, moving] = words else { return false };
    is_one_of(which, &["which"])
        && is_one_of(it, &["it"])
        && is_one_of(was, &["was", "had"])
        && is_one_of(moving, &["moving", "travelling", "been"])
}

/// `Continues to move in its` direction: in that which it had.
fn keeps_its(before: &[Token]) -> bool {
    let [.., toward, its] = before else { return false };
    let near = &before[before.len().saturating_sub(7)..];
    is_one_of(toward, &["in"])
        && is_one_of(its, &["its", "their"])
        && says(near, &["continues", "continue", "continued", "carries", "keeps"])
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn only_who_has_met_meets_again() {
        let line = "successive/no-more-collisions";
        let table = [
            (line, "*A* does not strike *B* again", "*A* does not strike *C* again", "`*A*` and `*C*` meet again"),
            (
                line,
                "*A* does not strike *B* again",
                "*A* does not collide with *C* again",
                "`*A*` and `*C*` meet again",
            ),
            (line, "*A* does not strike *B* again", "*A* and *C* do not collide again", "`*A*` and `*C*` meet again"),
            (line, "*A* does not strike *B* again", "*A* and *B* do not collide again", ""),
            (line, "*A* does not strike *B* again", "*B* is not struck again by *A*", ""),
        ];
        assert_said(&table);
    }

    #[test]
    fn who_moves_on_in_a_direction_or_meets_again_does_so() {
        let table = [
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. *A* continues in the opposite direction.",
                "`*A*` moves in the opposite",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly, and *B* continues to move in its direction.",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. After that *A* moves in the direction opposite to that in which it was moving.",
                "then moves against its old direction",
            ),
            (
                "direct/mass-from-the-velocities",
                "opposite to\nits old one",
                "of its old one",
                "`*A*` then moves in its old",
            ),
            ("direct/mass-from-the-velocities", "to\nits old one", "to that of its former motion", ""),
            (
                "direct/mass-from-the-velocities",
                "opposite to\nits old one",
                "that it had, as before",
                "in its old direction",
            ),
            (
                "ranges/direction-reversed",
                "collide directly",
                "collide directly and *A* continues in its direction",
                "`*A*` then moves in its old direction",
            ),
            (
                "direct/velocities-in-letters",
                "taking the direction of motion of *A* before it as",
                "taking the direction opposite to the motion of *A* as",
                "take the other direction as positive",
            ),
            (
                "ranges/turned-back-by-an-oblique-impact",
                "directed away from *B*",
                "directed towards *B*",
                "`*A*` then moves towards *B*",
            ),
            (
                "successive/second-collision",
                "*B* collides with *A* again",
                "*B* does not collide with *A* again",
                "do not meet again, and with the conditions of the scene they meet",
            ),
            (
                "successive/no-more-collisions",
                "does not strike *B* again",
                "strikes *B* again",
                "meet again, and with the conditions of the scene they do not meet",
            ),
            (
                "successive/no-more-collisions",
                "second.B.after.n >= A.after.n",
                "A.after.n > second.B.after.n",
                "do not meet again",
            ),
            (
                "ranges/mass-ratio-that-can-be",
                "with speed {vA}.",
                "with speed {vA}. After it *A* moves in the opposite direction.",
                "`*A*` moves in the opposite direction, and it is not so",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. The speed of *A* increases.",
                "say `increases` of the speed of `*A*`",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. The speed of *B* is increased.",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide. After it both spheres move in opposite directions.",
                "in opposite",
            ),
        ];
        assert_said(&table);
    }
}
