//! The impacts that come later.

use std::fmt;

use super::Reader;
use crate::mechanics::Sphere;
use crate::mechanics::later::{LATER, Meeting, ordinal, row};
use crate::mechanics::scene::{Contact, Given, Scene, Then, Velocity};
use crate::mechanics::scene_text::{SceneText, Sense, ThenText, VelocityText};
use crate::mechanics::setting::Setting;
use crate::number::Value;

/// What is known of who has taken part so far: their masses.
type Bodies = Vec<(Sphere, Option<Given>)>;

/// A field of a later impact.
#[derive(Clone, Copy)]
struct Field<'n> {
    /// Which of the later impacts, the first of them one.
    number: u8,
    name: &'n str,
}

impl fmt::Display for Field<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "then[{}].{}", self.number - 1, self.name)
    }
}

impl Reader<'_> {
    /// Every later impact as a scene by itself, with A and B for who meets there.
    pub(super) fn then<S: AsRef<str>>(&mut self, text: &SceneText<S>, first: &Scene) -> Vec<Then> {
        let texts = text.then.as_slice();
        if texts.len() > LATER.len() {
            let label = "at most three later impacts, four with the first";
            self.misfit("then", "there are too many impacts", label, "end with the last impact that is asked about");
            return Vec::new();
        }
        if !texts.is_empty() && first.setting == Setting::Impulse {
            let help = "begin with two spheres, or with a sphere and a `wall`";
            self.misfit(
                "then",
                "an impulse is followed by an impact",
                "only an impact can be followed by another",
                help,
            );
            return Vec::new();
        }
        let mut bodies: Bodies = vec![(Sphere::A, first.masses[0].clone())];
        if !first.setting.is_of_one() {
            bodies.push((Sphere::B, first.masses[1].clone()));
        }
        let mut all: Vec<Then> = Vec::new();
        for (then, number) in texts.iter().zip(1..) {
            let in_a_line = first.setting == Setting::Direct || text.is_in_one_line();
            let is_mixed = self.is_mixed(then, number, in_a_line);
            let one = self.one(then, number, first, &mut bodies).filter(|_| !is_mixed);
            let before: Vec<Meeting> = all.iter().map(|then| then.meeting).collect();
            if let Some(one) = &one
                && first.setting == Setting::Direct
            {
                self.in_their_row(one.meeting, &before);
            }
            all.extend(one);
        }
        all
    }

    /// Is the velocity of who is new along a line where the others are in a plane, or the other way round?
    fn is_mixed<S: AsRef<str>>(&mut self, then: &ThenText<S>, number: u8, in_a_line: bool) -> bool {
        let Some(before) = &then.before else { return false };
        let field = format!("then[{}].before", number - 1);
        match (self.is_along(before), in_a_line) {
            (true, false) => self.along_among_others(before, &field),
            (false, true) if !matches!(before, VelocityText::Along(_)) => {
                let expected = "expected one number, positive from A to B, as the others move along one line";
                let help = "give its velocity along the line, as in `\"-3\"`";
                self.misfit(&field, "a velocity in a plane among others along a line", expected, help);
            }
            _ => return false,
        }
        true
    }

    /// Spheres on one line meet the next one, and are named in the order in which they lie there.
    fn in_their_row(&mut self, meeting: Meeting, before: &[Meeting]) {
        let line = row(before);
        let place = |sphere: Sphere| line.iter().position(|other| *other == sphere);
        let last = line.len().saturating_sub(1);
        let [one, other] = meeting.of;
        let is_so = match (place(one), place(other)) {
            // Which way it moves the numbers say.
            _ if meeting.with_wall => return,
            (Some(one), Some(other)) => one + 1 == other,
            (Some(one), None) => one == last,
            (None, Some(other)) => other == 0,
            (None, None) => return,
        };
        if !is_so {
            let names = |row: &[Sphere]| row.iter().map(|sphere| sphere.name()).collect::<Vec<_>>().join(", ");
            let message = format!("{} and {} are not next to each other in this order", one.name(), other.name());
            let label = format!("on their line the spheres lie in the order {}", names(&line));
            let help = "name two that are neighbours, the one first that lies first on the line";
            self.misfit(&format!("then[{}].of", meeting.number - 1), &message, &label, help);
        }
    }

    fn one<S: AsRef<str>>(
        &mut self,
        text: &ThenText<S>,
        number: u8,
        first: &Scene,
        bodies: &mut Bodies,
    ) -> Option<Then> {
        let field = |name| Field { number, name };
        let of = self.who_meets(text, field("of"))?;
        let is_new = |sphere: Sphere, bodies: &Bodies| bodies.iter().all(|(known, _)| *known != sphere);
        let new: Vec<Sphere> = of.iter().copied().filter(|sphere| is_new(*sphere, bodies)).collect();
        if new.len() == of.len() {
            let message = format!("nobody in the {} impact has taken part before", ordinal(number));
            let earlier: Vec<String> = bodies.iter().map(|(sphere, _)| format!("`{}`", sphere.name())).collect();
            let label = format!("one must come from an earlier impact: {}", earlier.join(" or "));
            let help = "put the impact before it in, or name the sphere that comes from one";
            self.misfit(&field("of").to_string(), &message, &label, help);
            return None;
        }
        let mass = self.optional(text.mass.as_ref(), field("mass"));
        let before = text.before.as_ref().and_then(|velocity| self.velocity(velocity, field("before")));
        if new.is_empty() && (mass.is_some() || before.is_some()) {
            let name = if mass.is_some() { "mass" } else { "before" };
            let message = format!("`{name}` is given where nobody is new");
            let label = match of.as_slice() {
                [_] => "it has taken part before: it keeps its mass, and comes with the velocity that it has by then",
                _ => {
                    "both have taken part before: they keep their masses, and come with the velocities that they have by then"
                }
            };
            self.misfit(&field(name).to_string(), &message, label, &format!("leave out `{name}`"));
            return None;
        }
        if let [sphere] = new[..] {
            let name = sphere.name();
            let label = format!("{name} takes part here for the first time");
            let number = ordinal(number);
            if text.mass.is_none() {
                let help = format!("add `mass`, such as `\"m{name}\"`");
                self.misfit(&field("mass").to_string(), &format!("the mass of {name} is missing"), &label, &help);
            }
            if text.before.is_none() {
                let message = format!("the velocity of {name} before the {number} impact is missing");
                let at_rest = if first.setting == Setting::Direct { "\"0\"" } else { "[\"0\", \"0\"]" };
                let help = format!("add `before`; if {name} is at rest, it is `{at_rest}`");
                self.misfit(&field("before").to_string(), &message, &label, &help);
            }
            before.as_ref()?;
        }
        bodies.extend(new.iter().map(|sphere| (*sphere, mass.clone())));
        let mass_of = |sphere: &Sphere| bodies.iter().find(|(known, _)| known == sphere)?.1.clone();
        let in_a_line = first.setting == Setting::Direct;
        let setting = match of.as_slice() {
            [_] => Setting::Wall,
            _ if in_a_line => Setting::Direct,
            _ => Setting::Oblique,
        };
        let contact = self.contact_of_later(text, setting, in_a_line, number);
        let restitution = self.optional(text.e.as_ref(), field("e"));
        let contact = contact?;
        let at_rest = || Some(Velocity::Components(Given::nought(), Given::nought()));
        let is_wall = setting == Setting::Wall;
        let velocity = |sphere: Option<&Sphere>| match sphere {
            None => at_rest(),
            Some(sphere) if new.contains(sphere) => before.clone(),
            Some(_) => None,
        };
        let scene = Scene {
            setting,
            masses: [mass_of(&of[0]), of.get(1).and_then(mass_of)],
            before: [velocity(of.first()), velocity(of.get(1))],
            after: [None, if is_wall { at_rest() } else { None }],
            contact: Some(contact),
            impulse: None,
            restitution,
            letters: self.letters.clone(),
            unknowns: Vec::new(),
            conditions: Vec::new(),
            maximise: None,
            then: Vec::new(),
        };
        let second = of.get(1).copied().unwrap_or_else(|| of[0].other());
        Some(Then { meeting: Meeting { number, of: [of[0], second], with_wall: is_wall }, scene })
    }

    /// One or two different spheres.
    fn who_meets<S: AsRef<str>>(&mut self, text: &ThenText<S>, field: Field) -> Option<Vec<Sphere>> {
        let named = |name: &S| Sphere::ALL.into_iter().find(|sphere| sphere.name() == name.as_ref());
        let of: Option<Vec<Sphere>> = text.of.iter().map(named).collect();
        let (message, label, help) = match (of.as_deref(), &text.wall) {
            (Some([_]), Some(_)) => return of,
            (Some([one, other]), None) if one != other => return of,
            (Some([_, _]), Some(_)) => (
                "two spheres and a wall in one impact",
                "one sphere strikes a wall, as in `[\"B\"]`",
                "leave out `wall`, or let each sphere strike it in a `[[scene.then]]` of its own",
            ),
            (Some([_]), None) => (
                "one sphere alone, and no wall",
                "two spheres strike each other, as in `[\"A\", \"B\"]`",
                "name who is struck; or add the wall, `wall = [\"x\", \"y\"]`, a vector along it",
            ),
            _ => (
                "it is not clear who meets",
                "expected two of `A`, `B` and `C`, or one and a `wall`",
                "write `of = [\"A\", \"B\"]`, or `of = [\"B\"]` with a `wall`",
            ),
        };
        self.misfit(&field.to_string(), message, label, help);
        None
    }

    fn contact_of_later<S: AsRef<str>>(
        &mut self,
        text: &ThenText<S>,
        setting: Setting,
        in_a_line: bool,
        number: u8,
    ) -> Option<Contact> {
        let field = |name| Field { number, name };
        let unwanted = [
            ("line_of_centres", text.line_of_centres.is_some() && setting != Setting::Oblique),
            ("sense", text.sense.is_some() && setting != Setting::Oblique),
        ];
        for (name, _) in unwanted.into_iter().filter(|(_, given)| *given) {
            let label = if setting == Setting::Wall {
                "a wall has its own direction"
            } else {
                "the spheres move along one line from the start"
            };
            self.misfit(
                &field(name).to_string(),
                &format!("`{name}` has no place here"),
                label,
                &format!("leave out `{name}`"),
            );
        }
        let (line, name) = match setting {
            Setting::Direct => return Some(Contact::Along(Value::ONE, Value::ZERO, Some(Sense::FromAToB))),
            Setting::Wall => (&text.wall, "wall"),
            _ => (&text.line_of_centres, "line_of_centres"),
        };
        let Some(line) = line else {
            let label = "two spheres that move in a plane have a line of centres in each of their impacts";
            let help = "add `line_of_centres = [\"x\", \"y\"]`, a vector along it";
            self.misfit(&field(name).to_string(), "the line of centres of a later impact is missing", label, help);
            return None;
        };
        let [x, y] = self.pair(line, field(name))?;
        if x.value.is_zero() && y.value.is_zero() {
            self.no_direction(&format!("{}[1]", field(name)), line[1].as_ref(), setting);
            return None;
        }
        if self.has_too_many_roots([&x.value, &y.value], line[1].as_ref(), &format!("{}[1]", field(name))) {
            return None;
        }
        if setting == Setting::Wall && in_a_line {
            if !x.value.is_zero() {
                let label = "a vector along the wall, and the spheres move straight at it";
                self.misfit(
                    &field(name).to_string(),
                    "the wall is not across the line of motion",
                    label,
                    "write `wall = [\"0\", \"1\"]`",
                );
            }
            return Some(Contact::Along(Value::ONE, Value::ZERO, None));
        }
        Some(match setting {
            Setting::Wall => Contact::Along(-y.value, x.value, None),
            _ => Contact::Along(x.value, y.value, text.sense.filter(|sense| *sense == Sense::FromAToB)),
        })
    }
}
