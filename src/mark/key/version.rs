//! The version that wrote a key, where it is not this one.

use serde::Deserialize;

use super::KeyFault;

/// This version.
const OWN: &str = env!("CARGO_PKG_VERSION");

/// Another version that wrote a key, and the code of its sheet.
#[derive(Deserialize)]
pub(super) struct Other {
    carom: String,
    #[serde(default)]
    code: String,
}

/// The version that wrote a key, if it says one and that is not this one.
pub(super) fn other(text: &str) -> Option<Other> {
    serde_json::from_str(text).ok().filter(|other: &Other| other.carom != OWN)
}

impl Other {
    /// Is it of a later series, such as 0.2 where this is 0.1? Within a series keys stay the same.
    pub fn is_later(&self) -> bool {
        series(&self.carom) > series(OWN)
    }

    pub fn fault(&self) -> KeyFault {
        let (version, code) = (&self.carom, &self.code);
        let own = match self.is_later() {
            true => format!("get carom {version}"),
            false => format!("mark with carom {version}"),
        };
        let help = match code.is_empty() {
            true => format!("{own}, or make the sheets again from their `lock.json` with this one"),
            false => format!("{own}, or have this one mark by the code of the sheet: `carom mark {code} SUBMISSIONS`"),
        };
        KeyFault {
            path: "carom".to_owned(),
            help,
            ..KeyFault::new(
                format!("this key was written by carom {version}, and this is carom {OWN}"),
                "expected a key of this version or of an earlier one",
            )
        }
    }
}

/// The first two numbers of a version; nothing of what is no version.
fn series(version: &str) -> Option<(u64, u64)> {
    let mut numbers = version.split('.').map(|number| number.parse().ok());
    Some((numbers.next()??, numbers.next()??))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_which_keys_are_of_a_later_series() {
        let written_by = |version: &str| Other { carom: version.to_owned(), code: String::new() };
        for later in ["999.0.0", "0.999.1", "999.1"] {
            assert!(written_by(later).is_later(), "{later}");
        }
        for earlier in ["0.0.9", OWN, "", "new", "v9"] {
            assert!(!written_by(earlier).is_later(), "{earlier}");
        }
        assert!(other(&format!("{{\"carom\": \"{OWN}\"}}")).is_none());
        assert!(other("{\"carom\": 7}").is_none() && other("{}").is_none() && other("no json").is_none());
    }
}
