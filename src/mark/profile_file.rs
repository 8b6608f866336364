//! A profile of a person's own, from a TOML file: what it leaves out is as in the usual one.

use serde::Deserialize;
use toml::Spanned;

use super::profile::{Charge, Profile};
use crate::diagnostic::{Diagnostic, Source, near};

/// The most figures that can be asked for.
const MOST_FIGURES: u32 = 9;

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct ProfileFile {
    name: Option<String>,
    about: Option<String>,
    figures: Option<Spanned<u32>>,
    inaccuracy: Option<Charge>,
    units: Option<Charge>,
    coordinates: Option<bool>,
    radians: Option<bool>,
    masses_omitted: Option<bool>,
    unresolved: Option<bool>,
}

impl Profile {
    /// Reads a profile; what the file does not say is as in the usual one.
    ///
    /// # Errors
    ///
    /// What is no TOML, an unknown field, or a value that makes no sense, with its place.
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
        let file: ProfileFile = toml::from_str(&source.text).map_err(|fault| vec![unread(source, &fault)])?;
        let usual = Profile::default();
        let figures = match file.figures {
            Some(figures) if !(1..=MOST_FIGURES).contains(figures.get_ref()) => {
                let message = format!("{} significant figures", figures.get_ref());
                let label = format!("from 1 to {MOST_FIGURES}");
                return Err(vec![Diagnostic::new(message, source, figures.span(), label)]);
            }
            Some(figures) => figures.into_inner(),
            None => usual.figures,
        };
        Ok(Profile {
            name: file.name.unwrap_or_else(|| source.file.to_string()),
            about: file.about.unwrap_or_default(),
            figures,
            inaccuracy: file.inaccuracy.unwrap_or(usual.inaccuracy),
            units: file.units.unwrap_or(usual.units),
            coordinates: file.coordinates.unwrap_or(usual.coordinates),
            radians: file.radians.unwrap_or(usual.radians),
            masses_omitted: file.masses_omitted.unwrap_or(usual.masses_omitted),
            unresolved: file.unresolved.unwrap_or(usual.unresolved),
        })
    }
}

/// The reader of TOML names what it found and then what it knows, between backticks.
fn unread(source: &Source, fault: &toml::de::Error) -> Diagnostic {
    let said = fault.message().replace("unknown variant", "unknown word");
    let said = said.lines().next().unwrap_or_default();
    let (found, expected) = said.split_once(", ").unwrap_or((said, "see `docs/marking.md`"));
    let between = |text: &str| text.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
    let (name, known) = (between(found), between(expected));
    let near = name.first().and_then(|name| near(name, known.iter().map(String::as_str)));
    let span = fault.span().unwrap_or(0..0);
    Diagnostic::new(found, source, span, expected).with_near(near)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fault_of_a_profile_says_where_and_what_there_is() {
        let cases = [
            ("figurs = 2", "unknown field `figurs`", Some("did you mean `figures`?")),
            ("units = \"allways\"", "unknown word `allways`", Some("did you mean `always`?")),
            ("figures = 0", "0 significant figures", None),
            ("figures = 40", "40 significant figures", None),
            ("figures = \"2\"", "invalid type: string \"2\"", None),
            ("radians = 1", "invalid type: integer `1`", None),
            ("figures 2", "key with no value", None),
        ];
        for (text, message, help) in cases {
            let fault = Profile::read(&Source::new("mine.toml", text)).unwrap_err().remove(0);
            assert!(fault.message.starts_with(message), "{text}: {fault}");
            assert_eq!(fault.help.as_deref(), help, "{text}");
            assert!(!fault.label.is_empty() && fault.span.end > 0, "{text}: {fault:?}");
        }
    }

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
                cells.into_iter().chain(rest.map(str::to_owned)).collect()
            })
            .collect();
        assert_eq!(rows.iter().take(expected.len()).cloned().collect::<Vec<_>>(), expected);
    }
}
