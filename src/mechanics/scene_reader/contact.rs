//! Where the spheres touch, and what they are: two spheres, a sphere and a wall, or one particle.

use super::Reader;
use crate::expr::{Expr, Fault, Span};
use crate::mechanics::scene::{Contact, Given};
use crate::mechanics::scene_text::{SceneText, Sense};
use crate::mechanics::setting::Setting;
use crate::number::Value;

impl Reader<'_> {
    /// What the impact is between, by what is given; what does not go together is a fault.
    pub(super) fn setting<S: AsRef<str>>(&mut self, text: &SceneText<S>) -> Setting {
        let velocities = [
            ("before.A", &text.before.a),
            ("before.B", &text.before.b),
            ("after.A", &text.after.a),
            ("after.B", &text.after.b),
        ];
        let given = velocities.iter().filter_map(|(field, velocity)| Some((*field, self.is_along(velocity.as_ref()?))));
        let given: Vec<(&str, bool)> = given.collect();
        let setting = if text.wall.is_some() {
            Setting::Wall
        } else if text.is_of_one_particle() {
            Setting::Impulse
        } else if given.iter().any(|(_, is_direct)| *is_direct) && !is_laid_in_a_plane(text, &given) {
            Setting::Direct
        } else {
            for (field, velocity) in velocities {
                if let Some(velocity) = velocity.as_ref().filter(|_| given.contains(&(field, true))) {
                    self.along_among_others(velocity, field);
                }
            }
            return Setting::Oblique;
        };
        let mut refuse = |field: &str, message: &str, expected: &str, help: &str| {
            self.fault(field, Fault::new(message, Span::default(), expected).try_this(help));
        };
        for (field, is_direct) in given {
            if is_direct != (setting == Setting::Direct) {
                let expected = "`\"u\"` for every velocity, along one line, or `[\"x\", \"y\"]` for every one";
                let help = "write this one as the others are";
                refuse(field, "velocities along a line and in a plane are mixed", expected, help);
            }
        }
        let alone = matches!(setting, Setting::Wall | Setting::Impulse);
        let of_b = [
            ("masses.B", text.masses.b.is_some()),
            ("before.B", text.before.b.is_some()),
            ("after.B", text.after.b.is_some()),
        ];
        let others = [
            ("line_of_centres", text.line_of_centres.is_some()),
            ("sense", text.sense.is_some()),
            ("radii", !text.radii.is_none()),
            ("positions", !text.positions.is_none()),
            ("impact_parameter", text.impact_parameter.is_some()),
            ("impulse", setting != Setting::Impulse && text.impulse.is_some()),
            ("e", setting == Setting::Impulse && text.e.is_some()),
        ];
        for (field, _) in others.into_iter().filter(|(_, given)| *given) {
            let message = match setting {
                Setting::Wall => "it is given beside a `wall`, which leaves no place for it",
                Setting::Impulse => "it is given beside an `impulse`, which leaves no place for it",
                _ => "it is given beside velocities along one line, which leave no place for it",
            };
            refuse(field, message, &format!("no `{field}`"), &format!("leave out `{field}`"));
        }
        if let Some((field, _)) = of_b.into_iter().find(|(_, given)| alone && *given) {
            let alone = if setting == Setting::Wall { "wall" } else { "impulse" };
            let list = field.trim_end_matches(".B");
            let expected = "`A` alone, with a `wall` or an `impulse`";
            let fault = Fault::new("there is no sphere B in this scene", Span::default(), expected);
            self.fault(field, fault.try_this(format!("take `B` out of `{list}`, or take `{alone}` out")));
        }
        setting
    }

    /// A fault of a wall or a line of centres that is nought.
    pub(super) fn no_direction(&mut self, field: &str, text: &str, setting: Setting) {
        self.whole_fault(field, text, "the vector nought has no direction:", "a vector");
        self.help(match setting {
            Setting::Wall => "give any vector along the wall: `[\"1\", \"0\"]` is along i",
            _ => "give any vector from the one centre to the other: `[\"1\", \"0\"]` is along i",
        });
    }

    /// What is given of the line of centres; of a wall it is the line across it.
    pub(super) fn contact<S: AsRef<str>>(&mut self, text: &SceneText<S>, setting: Setting) -> Option<Contact> {
        match (setting, &text.wall) {
            (Setting::Direct, _) => return Some(Contact::Along(Value::ONE, Value::ZERO, Some(Sense::FromAToB))),
            (Setting::Wall, Some(wall)) => {
                let [x, y] = self.pair(wall, "wall")?;
                if x.value.is_zero() && y.value.is_zero() {
                    self.no_direction("wall[1]", wall[1].as_ref(), setting);
                    return None;
                }
                if self.has_too_many_roots([&x.value, &y.value], wall[1].as_ref(), "wall[1]") {
                    return None;
                }
                return Some(Contact::Along(-y.value, x.value, None));
            }
            _ => {}
        }
        let [a, b] = self.radii(text);
        let ways = [text.line_of_centres.is_some(), !text.positions.is_none(), text.impact_parameter.is_some()];
        if ways.iter().filter(|way| **way).count() > 1 {
            let message = "the line of centres is given in more than one way";
            let expected = "one of `line_of_centres`, `positions`, `impact_parameter`";
            self.fault("line_of_centres", Fault::new(message, Span::default(), expected));
            self.help("keep one of them");
            return None;
        }
        if let Some([x, y]) = &text.line_of_centres {
            let x = self.value(x.as_ref(), "line_of_centres[0]");
            let y_given = self.value(y.as_ref(), "line_of_centres[1]");
            let (x, y_value) = (x?.value, y_given?.value);
            if x.is_zero() && y_value.is_zero() {
                self.no_direction("line_of_centres[1]", y.as_ref(), setting);
                return None;
            }
            if self.has_too_many_roots([&x, &y_value], y.as_ref(), "line_of_centres[1]") {
                return None;
            }
            let sense = text.sense.filter(|sense| *sense == Sense::FromAToB);
            return Some(Contact::Along(x, y_value, sense));
        }
        if text.positions.is_none() && text.impact_parameter.is_none() {
            return None;
        }
        if text.radii.a.is_none() || text.radii.b.is_none() {
            let fault = Fault::new("the radii are missing", Span::default(), "it needs `radii` of both A and B");
            let given = if text.impact_parameter.is_some() { "impact_parameter" } else { "positions" };
            let field = if text.radii.is_none() { given } else { "radii" };
            self.fault(field, fault.try_this("add `radii` for A and for B, such as `\"1\"` for each"));
        }
        let (a, b) = (a?, b?);
        let sum = &a.value + &b.value;
        let shown = if a.shown == b.shown {
            Expr::product([Expr::integer(2), a.shown.clone()])
        } else {
            Expr::sum([a.shown.clone(), b.shown.clone()])
        };
        if let Some(offset) = &text.impact_parameter {
            let offset = self.value(offset.as_ref(), "impact_parameter")?;
            return Some(Contact::Offset { offset, radii: Box::new([a, b]), sum: Given { value: sum, shown } });
        }
        let mut place = |position: Option<&[S; 2]>, sphere: &str| -> Option<[Value; 2]> {
            let Some([x, y]) = position else {
                let message = format!("the position of {sphere} is missing");
                self.fault("positions", Fault::new(message, Span::default(), "`positions` of both A and B"));
                self.help(&format!("add the centre of {sphere}, its components along i and along j"));
                return None;
            };
            let x = self.value(x.as_ref(), format_args!("positions.{sphere}[0]"));
            let y = self.value(y.as_ref(), format_args!("positions.{sphere}[1]"));
            Some([x?.value, y?.value])
        };
        let a = place(text.positions.a.as_ref(), "A");
        let b = place(text.positions.b.as_ref(), "B");
        let ([a_x, a_y], [b_x, b_y]) = (a?, b?);
        Some(Contact::Apart(&b_x - &a_x, &b_y - &a_y, sum))
    }
}

impl Reader<'_> {
    /// The radii. Where the line of centres is given they are for the words alone, and still lengths.
    fn radii<S: AsRef<str>>(&mut self, text: &SceneText<S>) -> [Option<Given>; 2] {
        [(text.radii.a.as_ref(), "radii.A"), (text.radii.b.as_ref(), "radii.B")].map(|(radius, field)| {
            let radius = self.optional(radius, field)?;
            if radius.value.sign().is_some_and(|sign| sign.is_le()) {
                let fault = Fault::new("a radius is not positive", Span::default(), "a length above 0");
                self.fault(field, fault.try_this("check its sign"));
            }
            Some(radius)
        })
    }
}

/// Is some velocity given in a plane, and do the others or the line of centres say that all are meant so?
fn is_laid_in_a_plane<S>(text: &SceneText<S>, given: &[(&str, bool)]) -> bool {
    let along_a_line = given.iter().filter(|(_, is_direct)| *is_direct).count();
    let in_a_plane = given.len() - along_a_line;
    let is_laid = text.line_of_centres.is_some() || text.impact_parameter.is_some() || !text.positions.is_none();
    in_a_plane > 0 && (is_laid || in_a_plane > along_a_line)
}
