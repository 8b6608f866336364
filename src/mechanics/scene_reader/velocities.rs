//! The velocities of a scene: along a line, by components, or by size and direction.

use std::fmt::Display;

use super::{Reader, at_most, formulas};
use crate::expr::{Meaning, degrees, evaluate, print, written};
use crate::mechanics::scene::{Given, Velocity};
use crate::mechanics::scene_text::{Pair, VelocityText};
use crate::number::Value;

impl Reader<'_> {
    pub(super) fn velocities<S: AsRef<str>>(
        &mut self,
        pair: &Pair<VelocityText<S>>,
        moment: &str,
    ) -> [Option<Velocity>; 2] {
        [(&pair.a, "A"), (&pair.b, "B")]
            .map(|(velocity, sphere)| self.velocity(velocity.as_ref()?, format_args!("{moment}.{sphere}")))
    }

    /// The components of a vector that was typed as one text, `4i + j`.
    fn vector_in_words(&self, text: &str) -> Option<[String; 2]> {
        let formula = formulas::read(text, self.angles).ok()?;
        match evaluate(&formula, &|name| self.meaning(name)) {
            Ok(Meaning::Vector(x, y)) => Some([x, y].map(|part| print::plain(&written(&part)))),
            _ => None,
        }
    }

    /// Is a velocity one number, along a line? A vector in one text is a fault of its own.
    pub(super) fn is_along<S: AsRef<str>>(&self, velocity: &VelocityText<S>) -> bool {
        matches!(velocity, VelocityText::Along(text) if self.vector_in_words(text.as_ref()).is_none())
    }

    /// A fault of one number among vectors. Here `4,1` is hardly a decimal number.
    pub(super) fn along_among_others<S: AsRef<str>>(&mut self, velocity: &VelocityText<S>, field: &str) {
        if let VelocityText::Along(text) = velocity
            && let Some(components) = self.vector_in_words(&format!("({})", text.as_ref()))
        {
            return self.vector_in_one_text(text.as_ref(), components, field);
        }
        let expected = "expected `[\"x\", \"y\"]`, as the others are in a plane";
        let help = "give its components along i and along j; of a sphere at rest they are `[\"0\", \"0\"]`";
        self.misfit(field, "a velocity along a line among others in a plane", expected, help);
    }

    fn vector_in_one_text(&mut self, text: &str, [x, y]: [String; 2], field: &str) {
        self.whole_fault(field, text, "a vector in one text", &format!("`[\"{x}\", \"{y}\"]`"));
        self.help("write the components along i and along j as a list of two texts");
    }

    pub(super) fn velocity<S: AsRef<str>>(
        &mut self,
        text: &VelocityText<S>,
        field: impl Display + Copy,
    ) -> Option<Velocity> {
        let polar = match text {
            VelocityText::Along(velocity) => {
                if !self.faults.is_empty() && self.faults.iter().any(|told| told.field == field.to_string()) {
                    return None;
                }
                if let Some(components) = self.vector_in_words(velocity.as_ref()) {
                    self.vector_in_one_text(velocity.as_ref(), components, &field.to_string());
                    return None;
                }
                return Some(Velocity::Components(self.value(velocity.as_ref(), field)?, Given::nought()));
            }
            VelocityText::Components(components) => {
                let [x, y] = self.pair(components, field)?;
                return Some(Velocity::Components(x, y));
            }
            VelocityText::Polar(polar) => polar,
        };
        let speed = self.value(polar.speed.as_ref(), format_args!("{field}.speed"));
        if speed.as_ref().is_some_and(|speed| speed.value.sign().is_some_and(|sign| sign.is_lt())) {
            self.whole_fault(
                &format!("{field}.speed"),
                polar.speed.as_ref(),
                "a negative speed",
                "a speed, not negative",
            );
            self.help("leave the sign out, and turn the direction round by 180° if it is meant to be the opposite one");
        }
        match (&polar.angle_deg, &polar.cos, &polar.sin) {
            (Some(angle), None, None) => {
                let field = format_args!("{field}.angle_deg");
                let formula = self.formula(angle.as_ref(), field)?;
                let turn = match degrees(&formula, &|name| self.meaning(name)) {
                    Ok(turn) => turn,
                    Err(fault) => {
                        self.located(angle.as_ref(), &field.to_string(), fault);
                        return None;
                    }
                };
                let Some(direction) = turn.direction() else {
                    self.whole_fault(&field.to_string(), angle.as_ref(), "too finely given an angle", &at_most());
                    return None;
                };
                let speed = speed?;
                Some(Velocity::Polar {
                    speed,
                    cos: direction.cos,
                    sin: direction.sin,
                    angle: Some((turn, self.filled(&formula))),
                })
            }
            (None, Some(cos), Some(sin)) => {
                let cos = self.value(cos.as_ref(), format_args!("{field}.cos"));
                let sin_given = self.value(sin.as_ref(), format_args!("{field}.sin"));
                let (speed, cos, sin_value) = (speed?, cos?.value, sin_given?.value);
                if !(&(&cos * &cos) + &(&sin_value * &sin_value)).equals(&Value::ONE) {
                    let message = "the squares of cosine and sine do not add up to 1 with";
                    self.whole_fault(
                        &format!("{field}.sin"),
                        sin.as_ref(),
                        message,
                        "a sine that belongs to the cosine",
                    );
                    return None;
                }
                Some(Velocity::Polar { speed, cos, sin: sin_value, angle: None })
            }
            (angle, cos, sin) => {
                let help = match (angle, cos, sin) {
                    (None, Some(_), None) => "add `sin`, the sine of the same angle",
                    (None, None, Some(_)) => "add `cos`, the cosine of the same angle",
                    (None, None, None) => "add `angle_deg`, the angle in degrees anticlockwise from i",
                    _ => "leave out `angle_deg`, or `cos` and `sin`",
                };
                let expected = "`angle_deg`, or both `cos` and `sin`";
                let field = format!("{field}.speed");
                self.whole_fault(&field, polar.speed.as_ref(), "a speed without one direction", expected);
                self.help(help);
                None
            }
        }
    }
}
