//! The impacts that come later.

use super::Reader;
use crate::expr::{Fault, Span};
use crate::mechanics::Sphere;
use crate::mechanics::later::{LATER, Meeting, ordinal};
use crate::mechanics::scene::{Contact, Given, Scene, Then, Velocity};
use crate::mechanics::scene_text::{Sense, ThenText};
use crate::mechanics::setting::Setting;
use crate::number::Value;

/// What is known of who has taken part so far: their masses.
type Bodies = Vec<(Sphere, Option<Given>)>;

impl Reader<'_> {
    /// Every later impact as a scene by itself, with A and B for who meets there.
    pub(super) fn then<S: AsRef<str>>(&mut self, texts: &[ThenText<S>], first: &Scene) -> Vec<Then> {
        let mut refuse = |field: &str, message: &str, expected: &str| {
            self.fault(field, Fault::new(message, Span::default(), expected));
        };
        if texts.len() > LATER.len() {
            refuse("then", "there are too many impacts", "at most four impacts, the first among them");
            return Vec::new();
        }
        if !texts.is_empty() && first.setting == Setting::Impulse {
            refuse("then", "an impulse is followed by an impact", "spheres, or a sphere and a wall, from the start");
            return Vec::new();
        }
        let mut bodies: Bodies = vec![(Sphere::A, first.masses[0].clone())];
        if !first.setting.is_of_one() {
            bodies.push((Sphere::B, first.masses[1].clone()));
        }
        texts.iter().zip(1..).filter_map(|(text, number)| self.one(text, number, first, &mut bodies)).collect()
    }

    fn one<S: AsRef<str>>(
        &mut self,
        text: &ThenText<S>,
        number: u8,
        first: &Scene,
        bodies: &mut Bodies,
    ) -> Option<Then> {
        let field = |name: &str| format!("then[{}].{name}", number - 1);
        let of = self.who_meets(text, &field("of"))?;
        let is_new = |sphere: Sphere, bodies: &Bodies| bodies.iter().all(|(known, _)| *known != sphere);
        let new: Vec<Sphere> = of.iter().copied().filter(|sphere| is_new(*sphere, bodies)).collect();
        if new.len() == of.len() {
            let message = format!("nobody of the {} impact took part in an earlier one", ordinal(number));
            self.fault(&field("of"), Fault::new(message, Span::default(), "a sphere that has been struck before"));
            return None;
        }
        let mass = self.optional(text.mass.as_ref(), &field("mass"));
        let before = text.before.as_ref().and_then(|velocity| self.velocity(velocity, &field("before")));
        if new.is_empty() && (mass.is_some() || before.is_some()) {
            let name = if mass.is_some() { "mass" } else { "before" };
            let message = "who meets here has taken part before, and has a mass and a velocity already";
            self.fault(&field(name), Fault::new(message, Span::default(), format!("no `{name}`")));
            return None;
        }
        if let (Some(sphere), None) = (new.first(), &before) {
            let message = format!("{} takes part for the first time, and its velocity is missing", sphere.name());
            self.fault(&field("before"), Fault::new(message, Span::default(), "`before`, its velocity by then"));
            return None;
        }
        bodies.extend(new.iter().map(|sphere| (*sphere, mass.clone())));
        let mass_of = |sphere: &Sphere| bodies.iter().find(|(known, _)| known == sphere)?.1.clone();
        let in_a_line = first.setting == Setting::Direct;
        let setting = match of.as_slice() {
            [_] => Setting::Wall,
            _ if in_a_line => Setting::Direct,
            _ => Setting::Oblique,
        };
        let contact = self.contact_of_later(text, setting, in_a_line, &field)?;
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
            restitution: self.optional(text.e.as_ref(), &field("e")),
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
    fn who_meets<S: AsRef<str>>(&mut self, text: &ThenText<S>, field: &str) -> Option<Vec<Sphere>> {
        let named = |name: &S| Sphere::ALL.into_iter().find(|sphere| sphere.name() == name.as_ref());
        let of: Option<Vec<Sphere>> = text.of.iter().map(named).collect();
        let expected =
            if text.wall.is_some() { "`[\"A\"]`, `[\"B\"]` or `[\"C\"]`" } else { "two of `A`, `B` and `C`" };
        match of {
            Some(of) if of.len() == 1 && text.wall.is_some() => Some(of),
            Some(of) if of.len() == 2 && of[0] != of[1] && text.wall.is_none() => Some(of),
            _ => {
                let message =
                    if text.wall.is_some() { "no one sphere that meets a wall" } else { "no two spheres that meet" };
                self.fault(field, Fault::new(message, Span::default(), expected));
                None
            }
        }
    }

    fn contact_of_later<S: AsRef<str>>(
        &mut self,
        text: &ThenText<S>,
        setting: Setting,
        in_a_line: bool,
        field: &dyn Fn(&str) -> String,
    ) -> Option<Contact> {
        let unwanted = [
            ("line_of_centres", text.line_of_centres.is_some() && setting != Setting::Oblique),
            ("sense", text.sense.is_some() && setting != Setting::Oblique),
        ];
        for (name, _) in unwanted.into_iter().filter(|(_, given)| *given) {
            let message = "it is given where a wall, or one line of all spheres, leaves no place for it";
            self.fault(&field(name), Fault::new(message, Span::default(), format!("no `{name}`")));
        }
        let (line, name) = match setting {
            Setting::Direct => return Some(Contact::Along(Value::ONE, Value::ZERO, Some(Sense::FromAToB))),
            Setting::Wall => (&text.wall, "wall"),
            _ => (&text.line_of_centres, "line_of_centres"),
        };
        let Some(line) = line else {
            let message = "the line of centres of a later impact is missing";
            self.fault(&field(name), Fault::new(message, Span::default(), "`line_of_centres = [\"x\", \"y\"]`"));
            return None;
        };
        let [x, y] = self.pair(line, &field(name))?;
        let path = format!("{}[1]", field(name));
        if x.value.is_zero() && y.value.is_zero() {
            self.whole_fault(&path, line[1].as_ref(), "the vector nought has no direction:", "a vector");
            return None;
        }
        if setting == Setting::Wall && in_a_line {
            if !x.value.is_zero() {
                self.whole_fault(&path, line[1].as_ref(), "a wall that is not across the line:", "`[\"0\", \"1\"]`");
            }
            return Some(Contact::Along(Value::ONE, Value::ZERO, None));
        }
        Some(match setting {
            Setting::Wall => Contact::Along(-y.value, x.value, None),
            _ => Contact::Along(x.value, y.value, text.sense.filter(|sense| *sense == Sense::FromAToB)),
        })
    }
}
