//! Masses by the name of their sphere, `4m_A`, where the question has a letter for them: `4m`.

use crate::expr::{Expr, print};
use crate::mark::key::KeyedQuestion;
use crate::mechanics::Sphere;

/// The masses that are given in letters: the sphere, by its letter and by its number, and what its mass is.
pub(super) struct GivenMasses(Vec<([char; 2], String)>);

impl GivenMasses {
    pub(super) fn of(question: &KeyedQuestion) -> GivenMasses {
        let each = Sphere::BOTH.into_iter().zip([['a', '1'], ['b', '2']]).zip(&question.scene.masses);
        let given = each.filter_map(|((sphere, names), mass)| {
            let shown = &mass.as_ref()?.shown;
            let is_its_own_name = matches!(shown, Expr::Name(name) if name.text == format!("m_{}", sphere.name()));
            (!shown.names().is_empty() && !is_its_own_name).then(|| (names, print::plain(shown)))
        });
        GivenMasses(given.collect())
    }

    /// What was typed with the question's letters in the place of such names; nothing if there are none. What stands before an
    /// equals sign or a colon is what something is called.
    pub(super) fn put_into(&self, typed: &str) -> Option<String> {
        if self.0.is_empty() || !typed.contains(['m', 'M']) {
            return None;
        }
        let signs: Vec<char> = typed.chars().collect();
        let (mut put, mut at, mut is_other) = (String::new(), 0, false);
        while at < signs.len() {
            match self.name_at(&signs, at) {
                Some((end, mass)) => {
                    put.push_str(mass);
                    (at, is_other) = (end, true);
                }
                None => {
                    put.push(signs[at]);
                    at += 1;
                }
            }
        }
        is_other.then_some(put)
    }

    /// The name of a mass that begins here: where it ends, and what the mass is.
    fn name_at(&self, signs: &[char], at: usize) -> Option<(usize, &str)> {
        let is_begun = |before: &char| before.is_alphabetic() || matches!(before, '_' | '\\');
        if !matches!(signs[at], 'm' | 'M') || at.checked_sub(1).is_some_and(|before| is_begun(&signs[before])) {
            return None;
        }
        let has = |place: usize, sign: char| signs.get(place) == Some(&sign);
        let mut end = at + 1 + usize::from(has(at + 1, '_'));
        let is_braced = has(end, '{');
        end += usize::from(is_braced);
        let sphere = signs.get(end)?.to_ascii_lowercase();
        end += 1;
        if is_braced && !has(end, '}') {
            return None;
        }
        end += usize::from(is_braced);
        let mut rest = signs[end..].iter();
        let is_longer = signs.get(end).is_some_and(|next| next.is_alphanumeric());
        let is_called = rest.find(|sign| !sign.is_whitespace()).is_some_and(|next| matches!(next, '=' | ':'));
        let is_alone = at.checked_sub(1).is_none_or(|before| !signs[before].is_ascii_digit());
        if is_longer || is_called && is_alone {
            return None;
        }
        let (_, mass) = self.0.iter().find(|(names, _)| names.contains(&sphere))?;
        Some((end, mass))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mass_by_the_name_of_its_sphere_is_what_the_question_has_for_it() {
        let masses = GivenMasses(vec![(['a', '1'], "m".to_owned())]);
        for (typed, put) in [
            ("4mA", Some("4m")),
            ("m_B = 4 m_{A}", Some("m_B = 4 m")),
            ("3m_B = 12m_1", Some("3m_B = 12m")),
            ("12m_A = 3mB", Some("12m = 3mB")),
            ("m_A = m", None),
            ("4mB", None),
            ("4mAu", None),
            ("4m", None),
            ("", None),
        ] {
            assert_eq!(masses.put_into(typed).as_deref(), put, "{typed}");
        }
    }
}
