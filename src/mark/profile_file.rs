//! A profile of a person's own, from a TOML file: what it leaves out is as in the usual one.

use std::ops::RangeInclusive;

use toml::Spanned;
use toml::de::DeValue;

use super::profile::{Charge, Profile};
use crate::bank::{Faults, Keys, kind, parse_even_empty};
use crate::diagnostic::{Diagnostic, Source};

/// How many figures can be asked for.
const FIGURES: RangeInclusive<u32> = 1..=9;

/// How many marks a number that is copied wrongly can cost.
const MISREAD: RangeInclusive<u32> = 0..=9;

/// How often a fault can cost a mark.
const CHARGES: [(&str, Charge); 3] = [("never", Charge::Never), ("once", Charge::Once), ("always", Charge::Always)];

impl Profile {
    /// Reads a profile; what the file does not say is as in the usual one.
    ///
    /// # Errors
    ///
    /// Everything that is wrong with it: what is no TOML, an unknown key, a value that makes no sense, each with its place.
    ///
    /// ```
    /// use carom::diagnostic::Source;
    /// use carom::mark::Profile;
    /// let own = Profile::read(&Source::new("mine.toml", "figures = 2\nunits = 'always'\n")).unwrap();
    /// assert_eq!((own.figures, own.inaccuracy), (2, Profile::default().inaccuracy));
    /// let fault = Profile::read(&Source::new("mine.toml", "figurs = 2\n")).unwrap_err();
    /// assert_eq!(fault[0].help.as_deref(), Some("did you mean `figures`?"));
    /// ```
    pub fn read(source: &Source) -> Result<Profile, Vec<Diagnostic>> {
        let faults = &mut Faults::new(source.clone());
        faults.model = "a profile has lines such as `figures = 3`; `docs/marking.md` says which";
        let Some(document) = parse_even_empty(&source.text, faults) else {
            return Err(std::mem::take(&mut faults.found));
        };
        let mut keys = Keys::of("a profile", document.get_ref(), document.span());
        let usual = Profile::default();
        let profile = Profile {
            name: keys.words("name", faults).map_or_else(|| source.file.to_string(), Spanned::into_inner),
            about: keys.words("about", faults).map_or_else(String::new, Spanned::into_inner),
            figures: whole(&mut keys, "figures", FIGURES, usual.figures, faults).unwrap_or(usual.figures),
            inaccuracy: charge(&mut keys, "inaccuracy", faults).unwrap_or(usual.inaccuracy),
            units: charge(&mut keys, "units", faults).unwrap_or(usual.units),
            coordinates: yes_or_no(&mut keys, "coordinates", faults).unwrap_or(usual.coordinates),
            radians: yes_or_no(&mut keys, "radians", faults).unwrap_or(usual.radians),
            misread: whole(&mut keys, "misread", MISREAD, usual.misread, faults).unwrap_or(usual.misread),
            masses_omitted: yes_or_no(&mut keys, "masses-omitted", faults).unwrap_or(usual.masses_omitted),
            unresolved: yes_or_no(&mut keys, "unresolved", faults).unwrap_or(usual.unresolved),
        };
        keys.finish(faults);
        if faults.found.is_empty() { Ok(profile) } else { Err(std::mem::take(&mut faults.found)) }
    }
}

fn whole(
    keys: &mut Keys,
    key: &'static str,
    range: RangeInclusive<u32>,
    usual: u32,
    faults: &mut Faults,
) -> Option<u32> {
    let value = keys.get(key)?;
    let message = match value.get_ref() {
        DeValue::Integer(number) => match u32::from_str_radix(number.as_str(), number.radix()) {
            Ok(number) if range.contains(&number) => return Some(number),
            _ => format!("`{key}` is {number}"),
        },
        DeValue::Float(number) => format!("`{key}` is {number}"),
        other => format!("`{key}` is {}", kind(other)),
    };
    let label = format!("expected a whole number from {} to {}", range.start(), range.end());
    faults.report(value.span(), message, label, format!("write `{key} = {usual}`, without quotes"));
    None
}

fn charge(keys: &mut Keys, key: &'static str, faults: &mut Faults) -> Option<Charge> {
    let value = keys.get(key)?;
    let label = "expected \"never\", \"once\" or \"always\"".to_owned();
    let DeValue::String(word) = value.get_ref() else {
        let help = format!("write `{key} = \"once\"`");
        faults.report(value.span(), format!("`{key}` is {}", kind(value.get_ref())), label, help);
        return None;
    };
    let found = CHARGES.into_iter().find(|(known, _)| known == word);
    if found.is_none() {
        let known = CHARGES.iter().map(|(known, _)| *known);
        faults.unknown(value.span(), format!("unknown word `{word}`"), label, word, known);
    }
    found.map(|(_, charge)| charge)
}

fn yes_or_no(keys: &mut Keys, key: &'static str, faults: &mut Faults) -> Option<bool> {
    let value = keys.get(key)?;
    if let DeValue::Boolean(is) = value.get_ref() {
        return Some(*is);
    }
    let message = format!("`{key}` is {}", kind(value.get_ref()));
    let help = format!("write `{key} = true` or `{key} = false`, without quotes");
    faults.report(value.span(), message, "expected true or false", help);
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_documents_every_profile() {
        let page = include_str!("../../docs/marking.md");
        let section = page.split("\n## Profiles\n").nth(1).expect("a section on profiles");
        let rows: Vec<Vec<&str>> = section
            .lines()
            .filter(|line| line.starts_with("| `"))
            .map(|row| row.trim_matches(['|', ' ']).split(" | ").map(str::trim).collect())
            .collect();
        let charge = |charge: Charge| match charge {
            Charge::Never => "never",
            Charge::Once => "once",
            Charge::Always => "always",
        };
        let yes = |is: bool| if is { "yes" } else { "no" };
        let expected: Vec<Vec<String>> = Profile::names()
            .filter_map(Profile::named)
            .map(|p| {
                let name = format!("`{}`", p.name);
                let (inaccuracy, units) = (charge(p.inaccuracy), charge(p.units));
                let rest = [p.coordinates, p.radians, p.masses_omitted, p.unresolved].map(yes);
                let cells = [name.as_str(), &p.figures.to_string(), inaccuracy, units].map(str::to_owned);
                let cells = cells.into_iter().chain([p.misread.to_string()]);
                cells.chain(rest.map(str::to_owned)).collect()
            })
            .collect();
        assert_eq!(rows.iter().take(expected.len()).cloned().collect::<Vec<_>>(), expected);
    }
}
