//! What the words say of who comes to rest.

use super::said::{Seen, moment};
use super::sentence::{Sentence, Token, is_one_of, says, subject};
use crate::examine::Finding;
use crate::mechanics::{Moment, Quantity, Sphere};

impl Seen<'_> {
    /// `*A* is brought to rest`, `which brings *A* to rest`, `*A* is then at rest`: so it is after the impact.
    pub(super) fn brought_to_rest(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        if !self.question.scene.then.is_empty() {
            return;
        }
        let named = (1..sentence.len()).filter_map(|at| Some((at, rests(sentence, at)?)));
        let both = (1..sentence.len()).filter(|at| both_rest(sentence, *at) && !self.is_alone());
        let both = both.flat_map(|at| Sphere::BOTH.map(|sphere| (at, sphere)));
        for (at, sphere) in named.chain(both).collect::<Vec<_>>() {
            let Some(speed) = self.known.number(Quantity::Speed(sphere, Moment::After)) else { continue };
            let is_denied = says(&sentence[..at], &["not", "never", "neither", "nor"]);
            let is_wrong = match is_denied {
                true => speed.is_zero(),
                false => (&speed * &speed).sign().is_some_and(|sign| sign.is_gt()),
            };
            if is_wrong {
                let rests = if is_denied { "does not come" } else { "comes" };
                let message = format!("the words say that `*{}*` {rests} to rest, and it is not so", sphere.name());
                let help = "mend the numbers or `conditions` of `[scene]`, or say what happens";
                let Token::Word(lead) = &sentence[at - 1] else { continue };
                findings.push(self.finding(message, &format!("{lead} rest"), help));
            }
        }
    }
}

impl Seen<'_> {
    /// `*A*, of mass 3 kg, is at rest when it collides`: so it is in the scene.
    pub(super) fn resting_when_struck(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        for at in 2..sentence.len() {
            let is_told = is_one_of(&sentence[at], &["rest"])
                && is_one_of(&sentence[at - 1], &["at"])
                && is_one_of(&sentence[at - 2], &["is", "was"])
                // What stands beside its name is told of elsewhere.
                && at > 2
                && sentence[at - 3] == Token::Comma;
            let is_struck = || {
                let mut when = sentence[at + 1..].iter().skip_while(|token| !is_one_of(token, &["when"]));
                when.any(|token| is_one_of(token, &["collides", "collide", "strikes", "struck", "hits", "hit"]))
            };
            let Some(sphere) = subject(&sentence[..at - 2]).filter(|_| is_told && is_struck()) else { continue };
            let first = self.first(sphere, Quantity::Speed(sphere, Moment::Before));
            let Some(speed) = first.and_then(|first| self.known.number(first)) else { continue };
            if (&speed * &speed).sign().is_some_and(|sign| sign.is_gt()) {
                let message = format!("the words say that `*{}*` is at rest, and in the scene it moves", sphere.name());
                let help = "say that it is moving, or give it no velocity in `[scene]`";
                findings.push(self.finding(message, "is at rest", help));
            }
        }
    }
}

impl Seen<'_> {
    /// `Runs into *A*, which is stationary`, `hits the stationary ball *A*`: so it is before the impact.
    pub(super) fn described_at_rest(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const STILL: [&str; 3] = ["stationary", "motionless", "rest"];
        for (at, token) in sentence.iter().enumerate().filter(|(_, token)| is_one_of(token, &STILL)) {
            let Some(sphere) = described(sentence, at) else { continue };
            let first = self.first(sphere, Quantity::Speed(sphere, Moment::Before));
            let Some(speed) = first.and_then(|first| self.known.number(first)) else { continue };
            let is_of_another_time = says(sentence, &["after", "afterwards", "until", "not", "initially"])
                || says(&sentence[..at], &["brought", "comes", "come", "later", "then"]);
            let moves = (&speed * &speed).sign().is_some_and(|sign| sign.is_gt());
            if moves && !is_of_another_time {
                let Token::Word(said) = token else { continue };
                let said = if said == "rest" { "at rest" } else { said };
                let message = format!("the words say that `*{}*` is {said}, and in the scene it moves", sphere.name());
                let help = "say that it is moving, or give it no velocity in `[scene]`";
                findings.push(self.finding(message, said, help));
            }
        }
    }
}

/// The sphere beside whose name stands the word that it does not move.
fn described(sentence: &[Token], at: usize) -> Option<Sphere> {
    const NOUNS: [&str; 7] = ["sphere", "ball", "particle", "smooth", "small", "uniform", "identical"];
    let before = match &sentence[..at] {
        [before @ .., lead] if is_one_of(&sentence[at], &["rest"]) && is_one_of(lead, &["at"]) => before,
        before if !is_one_of(&sentence[at], &["rest"]) => before,
        _ => return None,
    };
    let clause = match before {
        [name, Token::Comma, which, is] | [.., name, Token::Comma, which, is] => Some((name, which, is)),
        _ => match before {
            [.., name, which, is] => Some((name, which, is)),
            _ => None,
        },
    };
    if let Some((Token::Sphere(sphere), which, is)) = clause
        && is_one_of(which, &["which", "that"])
        && is_one_of(is, &["is", "was", "lies"])
    {
        return Some(*sphere);
    }
    // `The stationary ball *A*`
    let next = sentence[at + 1..].iter().find(|token| !is_one_of(token, &NOUNS));
    match next {
        Some(Token::Sphere(sphere)) if !is_one_of(&sentence[at], &["rest"]) => Some(*sphere),
        _ => None,
    }
}

/// Who is said at this word to come to rest.
fn rests(sentence: &[Token], at: usize) -> Option<Sphere> {
    const COMES: [&str; 8] = ["brought", "comes", "come", "coming", "came", "brings", "bring", "bringing"];
    const AFTER: [&str; 2] = ["after", "afterwards"];
    let is_led = |lead: &str| is_one_of(&sentence[at - 1], &[lead]);
    if !is_one_of(&sentence[at], &["rest"]) || says(sentence, &["before"]) {
        return None;
    }
    let verb = sentence[..at].iter().rposition(|token| is_one_of(token, &COMES));
    // `The impulse needed to bring *A* to rest` says nothing of what happens.
    let is_infinitive = |verb: usize| verb > 0 && is_one_of(&sentence[verb - 1], &["to"]);
    // `Hits a stone *B* that has come to rest`: it did so before.
    let is_over = |verb: usize| {
        verb > 0 && is_one_of(&sentence[verb - 1], &["has", "had", "having"]) && moment(sentence, at) == Moment::Before
    };
    match verb {
        Some(verb) if is_infinitive(verb) || is_over(verb) => None,
        Some(verb) if is_led("to") => match sentence[verb + 1..at - 1] {
            [] => subject(&sentence[..verb]),
            [Token::Sphere(sphere)] => Some(sphere),
            _ => None,
        },
        _ if is_led("at") => match &sentence[..at - 1] {
            [.., leaves, Token::Sphere(sphere)] if is_one_of(leaves, &["leaves", "leaving"]) => Some(*sphere),
            [before @ .., then] if is_one_of(then, &["then"]) => subject(before),
            before => {
                let is_after = sentence[at + 1..].iter().take(2).any(|next| is_one_of(next, &AFTER))
                    // `Immediately after the collision *B* is at rest`
                    || (moment(sentence, at) == Moment::After && before.last().is_some_and(|is| is_one_of(is, &["is"])));
                subject(before).filter(|_| is_after)
            }
        },
        _ => None,
    }
}

/// `Both spheres are brought to rest`, `they come to rest`
fn both_rest(sentence: &[Token], at: usize) -> bool {
    const COME: [&str; 4] = ["brought", "come", "came", "coming"];
    let before = &sentence[..at];
    let comes = before.len() > 1
        && is_one_of(&before[before.len() - 1], &["to"])
        && is_one_of(&before[before.len() - 2], &COME);
    let names_any = before.iter().any(|token| matches!(token, Token::Sphere(_)));
    is_one_of(&sentence[at], &["rest"]) && comes && says(before, &["both", "they"]) && !names_any
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn who_comes_to_rest_is_at_rest_after_the_impact() {
        let table = [
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly, which brings *A* to rest.",
                "`*A*` comes to rest, and it is not so",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. Given that *A* is brought to rest, all is known.",
                "`*A*` comes to rest",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly, leaving *A* at rest.",
                "`*A*` comes to rest",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. *A* is at rest immediately after this.",
                "`*A*` comes to rest",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. *A* cannot be brought to rest.",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. *A* is not brought to rest.",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. An impulse is needed to bring *A* to rest.",
                "",
            ),
            (
                "rest/speeds-and-directions",
                "The coefficient",
                "Immediately after the collision *B* is at rest. The coefficient",
                "`*B*` comes to rest",
            ),
            ("rest/speeds-and-directions", "which is at rest on the plane", "which has come to rest on the plane", ""),
            (
                "rest/speeds-and-directions",
                "The spheres have",
                "*A* meets the stationary ball *B*. The spheres have",
                "",
            ),
            (
                "rest/speeds-and-directions",
                "The spheres have",
                "*B* runs into *A*, which is stationary. The spheres have",
                "`*A*` is stationary, and in the scene it moves",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "*A* meets the stationary sphere *B*. The coefficient",
                "`*B*` is stationary",
            ),
            (
                "rest/speeds-and-directions",
                "The coefficient",
                "After the collision *A* has come to rest. The coefficient",
                "`*A*` comes to rest",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "Both spheres are brought to rest. The coefficient",
                "`*A*` comes to rest",
            ),
        ];
        assert_said(&table);
    }
}
