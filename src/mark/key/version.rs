//! The version that wrote a key, where it is not this one.

use serde::Deserialize;
use serde_json::Value as Json;

use super::KeyFault;
use crate::paper::{is_of_later_series, series};

/// This version.
const OWN: &str = env!("CARGO_PKG_VERSION");

/// Another version that wrote a key, and the code of its sheet.
pub(super) struct Other {
    carom: String,
    code: String,
}

#[derive(Deserialize)]
struct Said {
    carom: Option<Json>,
    #[serde(default)]
    code: Json,
}

/// The version that wrote a key, if it says one and that is not this one.
///
/// # Errors
///
/// What stands in place of a version and is none.
pub(super) fn other(text: &str) -> Result<Option<Other>, Vec<KeyFault>> {
    let said = serde_json::from_str(text).ok().and_then(|said: Said| Some((said.carom?, said.code)));
    let Some((carom, code)) = said else { return Ok(None) };
    let Some(version) = carom.as_str().filter(|version| series(version).is_some()) else {
        let said = carom.as_str().map_or_else(|| carom.to_string(), |version| version.escape_debug().to_string());
        let message = format!("`{said}` is no version of carom");
        let fault = KeyFault::new(message, format!("expected a version, such as `{OWN}`"));
        let help = "put back what `carom sheet` wrote, or leave `carom` out".to_owned();
        return Err(vec![KeyFault { help, ..fault.below("carom") }]);
    };
    let other = Other { carom: version.to_owned(), code: code.as_str().unwrap_or_default().to_owned() };
    Ok((version != OWN).then_some(other))
}

impl Other {
    /// Is it of a later series, such as 0.2 where this is 0.1?
    pub fn is_later(&self) -> bool {
        is_of_later_series(&self.carom)
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
        let is_own = |text: &str| matches!(other(text), Ok(None));
        assert!(is_own(&format!("{{\"carom\": \"{OWN}\"}}")));
        assert!(is_own("{}") && is_own("no json") && is_own("{\"carom\": null}"));
        for none in ["7", "\"banana\"", "\"\"", "\"1\"", "\"v0.1.0\"", "[]"] {
            let fault = other(&format!("{{\"carom\": {none}}}")).err().unwrap().remove(0);
            assert_eq!(
                (fault.path.as_str(), fault.message),
                ("carom", format!("`{}` is no version of carom", none.trim_matches('"')))
            );
        }
    }
}
