//! What the words say of angles: how large they are, from which line they are measured, and what their sine is.

use super::impacts::wall_measured_from;
use super::said::Seen;
use super::sentence::{Sentence, Token, measured_from};
use crate::bank::names_in_degrees;
use crate::examine::Finding;
use crate::expr::{Expr, Function, Meaning, Piece, Relation, Turn, holds, print, written_angle};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::{Angle, Letter, Value};

impl Seen<'_> {
    /// What is said of the acute angle of a velocity, measured from the line that the words name after it, and what it is.
    pub(super) fn angle(
        &self,
        sphere: Sphere,
        moment: Moment,
        expr: &Expr,
        after: &[Token],
    ) -> Option<(String, String)> {
        let from = measured_from(after)?;
        let (across, along) = match wall_measured_from(&self.question.scene, after) {
            Some(wall) => self.to_wall(sphere, moment, wall)?,
            None => self.known.direction(self.first(sphere, Quantity::AngleToLine(sphere, moment))?)?,
        };
        let (y, x) = if from == Axis::N { (across, along) } else { (along, across) };
        let has = Angle::of(&y, &x)?;
        if let (Some(said), Some(has)) = (self.meaning(expr).and_then(degrees_said), Turn::of(has.clone()).to_f64()) {
            let is_apart = (said - has).abs() > 1e-6 && said < 90.0;
            let shown = |degrees: f64| format!("{degrees:.4}").trim_end_matches('0').trim_end_matches('.').to_owned();
            return is_apart.then(|| (shown(said), shown(has)));
        }
        // Of letters only what goes before is given; what comes after is to be found, unless an equation gives it.
        let is_in = |value: &Value, name: &str| value.has_letter(|letter| letter.name() == name);
        let Expr::Name(letter) = expr else { return None };
        let is_given = is_in(&y, &letter.text) || is_in(&x, &letter.text);
        let is_given = is_given && moment == Moment::Before;
        let (y, x) = (&y * &y, &x * &x);
        let is_so = |tangent: &Value| y.equals(&(tangent * &x));
        let by_itself = || {
            let tangent = self.number(&names_in_degrees(&Expr::call(Function::Tan, expr.clone())))?;
            Some(&tangent * &tangent)
        };
        // An acute angle that is found has its tangent for a value.
        let found = || {
            let its = |(own, _): &&(_, Value)| Letter::name(own) == letter.text;
            let (_, tangent) = self.variant.solution.found().iter().find(its)?;
            self.question.scene.symbols.get(&letter.text).filter(|range| *range == "acute")?;
            Some(tangent * tangent)
        };
        let is_before = moment == Moment::Before;
        let all = [by_itself().filter(|_| is_given), self.tangent_said(&letter.text), found().filter(|_| is_before)];
        let said: Vec<Value> = all.into_iter().flatten().collect();
        if said.is_empty() || said.iter().any(is_so) {
            return None;
        }
        let said = Angle::of(&said[0].square_root()?, &Value::ONE)?;
        let shown = |angle: &Angle| print::unicode(&written_angle(angle));
        Some((shown(&said), shown(&has)))
    }

    /// How large the components of a velocity are along the wall of an impact, which may come later, and across it.
    fn to_wall(&self, sphere: Sphere, moment: Moment, wall: u8) -> Option<(Value, Value)> {
        let of = |axis| self.known.number(self.first(sphere, Quantity::Velocity(sphere, moment, axis))?);
        let ([x, y], (u, v)) = (self.along_wall(wall)?, (of(Axis::X)?, of(Axis::Y)?));
        let size = |value: Value| if value.sign().is_some_and(|sign| sign.is_lt()) { -&value } else { value };
        Some((size(&(&u * &x) + &(&v * &y)), size(&(&u * &y) - &(&v * &x))))
    }

    /// The square of the tangent that an equation of the words gives to an angle, by its tangent, sine or cosine.
    fn tangent_said(&self, angle: &str) -> Option<Value> {
        let of_it = |expr: &Expr| {
            let Expr::Relation(left, Relation::Equal, right) = expr else { return None };
            let Expr::Call(function, argument) = &**left else { return None };
            let is_its = matches!(&**argument, Expr::Name(name) if name.text == angle);
            let value = self.number(right).filter(|_| is_its)?;
            let square = &value * &value;
            let rest = &Value::ONE - &square;
            match function {
                Function::Tan => Some(square),
                Function::Sin => square.divided_by(&rest),
                Function::Cos => rest.divided_by(&square),
                _ => None,
            }
        };
        self.stem().flat_map(|text| &text.0).find_map(|piece| match piece {
            Piece::Formula(expr) => of_it(expr),
            _ => None,
        })
    }

    /// Equations and inequalities between what is given that do not hold.
    pub(super) fn equations(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        for token in sentence {
            let Token::Number(relation @ Expr::Relation(left, _, right), _, lead) = token else { continue };
            let is_given = |side: &Expr| match self.meaning(&names_in_degrees(side)) {
                Some(Meaning::Number(value)) => value.is_constant(),
                Some(Meaning::Angle(turn) | Meaning::Degrees(turn)) => turn.is_constant(),
                _ => false,
            };
            let is_so = || holds(&names_in_degrees(relation), &|name| self.variant.givens.meaning(name));
            if is_given(left) && is_given(right) && is_so() == Ok(Some(false)) {
                let message = format!("the words say that `{}`, and it is not so", print::plain(relation));
                findings.push(self.finding(message, lead, "say what it is, or give other values to its names"));
            }
        }
    }
}

/// The degrees of a number or angle in the words.
fn degrees_said(meaning: Meaning) -> Option<f64> {
    match meaning {
        Meaning::Number(value) => value.to_f64(),
        Meaning::Angle(turn) | Meaning::Degrees(turn) => turn.to_f64(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn an_angle_or_a_speed_that_nothing_names_is_one_still() {
        let (rest, wall, two) =
            ("rest/speeds-and-directions", "walls/rebound-speed-and-direction", "successive/tangents-at-two-walls");
        let makes = "the direction of motion of *A* makes an acute angle of\n{alpha deg} with the line of centres of the spheres.";
        let (line, speeds) =
            ("direct/one-sphere-catches-the-other", "The speed of *A* is {u m/s} and the speed of *B* is {w m/s}. The");
        let path = "its direction of motion makes an acute angle of\n{alpha deg} with the wall";
        let table = [
            (rest, makes, "*A* is moving at {alpha deg} to the line of centres of the spheres.", ""),
            (rest, makes, "*A* is moving at {alpha deg} to the common tangent at the point of contact.", "the angle"),
            (wall, path, "it is moving at {alpha deg} to the wall", ""),
            (wall, path, "it is moving at {alpha deg} to the normal to the wall", "the angle"),
            (two, "at an acute angle {alpha} to the first wall", "at {alpha} to the first wall", ""),
            (two, "at an acute angle {alpha} to the first wall", "at {alpha} to the second wall", "the angle"),
            (line, speeds, "*A* is moving at {u m/s} and *B* at {w m/s}. The", ""),
            (line, speeds, "*A* is moving at {w m/s} and *B* at {u m/s}. The", "the speed"),
        ];
        assert_said(&table);
    }

    #[test]
    fn an_equation_of_the_words_holds() {
        let table = [(
            "rest/speeds-and-directions",
            "spheres is {e}.",
            "spheres is {e}, and {sin(alpha) = 5/7}.",
            "the words say that `sin(alpha) = 5/7`",
        )];
        assert_said(&table);
    }
}
