//! What is remembered of questions that have been found sound, so that they need not be examined again.
//!
//! A file for each text of a question, named by it. In it stand the whole text, which build of carom found it sound, and
//! the census; all three must agree, and a sum over them too, or the file counts for nothing. A question with a finding is
//! never remembered. So whatever stands in the folder, torn, old or typed by a person, can cost time and hide no fault.

use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};

use serde::{Deserialize, Serialize};

use crate::bank::Heading;
use crate::examine::{Coverage, MarkCount, Report, StyleReport};

/// Which carom this is: a number over all of its source.
const BUILD: &str = env!("CAROM_SOURCE");

/// The folder.
pub struct Cache {
    folder: PathBuf,
}

#[derive(Serialize, Deserialize)]
struct Entry {
    build: String,
    id: String,
    text: String,
    styles: Vec<StyleReport>,
    scripts: usize,
    marks: Vec<MarkCount>,
}

impl Cache {
    /// The folder that this machine has for such things; none if it has none.
    pub fn open() -> Option<Cache> {
        let of = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
        let home = || of("HOME");
        let caches = match std::env::consts::OS {
            "windows" => of("LOCALAPPDATA"),
            "macos" => of("XDG_CACHE_HOME").or_else(|| Some(home()?.join("Library").join("Caches"))),
            _ => of("XDG_CACHE_HOME").or_else(|| Some(home()?.join(".cache"))),
        };
        Some(Cache { folder: caches?.join("carom").join("check") })
    }

    /// The report of a question that this very carom has found sound.
    pub fn sound(&self, heading: &Heading) -> Option<Report> {
        let kept = fs::read_to_string(self.path(heading)).ok()?;
        let (sum, entry) = kept.split_once('\n')?;
        if sum != hash(entry) {
            return None;
        }
        let entry: Entry = serde_json::from_str(entry).ok()?;
        let is_same = entry.build == BUILD && entry.id == heading.id && *entry.text == *heading.source.text;
        let coverage = Coverage { marks: entry.marks, scripts: entry.scripts, faults: Vec::new() };
        (is_same && coverage.idle().next().is_none()).then_some(Report {
            styles: entry.styles,
            findings: Vec::new(),
            coverage,
        })
    }

    /// Keeps the report of a question if nothing is amiss with it. A folder that cannot be written to is no fault.
    pub fn remember(&self, heading: &Heading, report: &Report) {
        if !report.findings.is_empty() {
            return;
        }
        let entry = Entry {
            build: BUILD.to_owned(),
            id: heading.id.clone(),
            text: heading.source.text.to_string(),
            styles: report.styles.clone(),
            scripts: report.coverage.scripts,
            marks: report.coverage.marks.clone(),
        };
        let Ok(entry) = serde_json::to_string(&entry) else { return };
        let _ = self.put(heading, &format!("{}\n{entry}", hash(&entry)));
    }

    /// Written beside its place and moved there whole, so that another carom never reads half of it.
    fn put(&self, heading: &Heading, text: &str) -> std::io::Result<()> {
        static WRITTEN: AtomicU64 = AtomicU64::new(0);
        fs::create_dir_all(&self.folder)?;
        let path = self.path(heading);
        let number = WRITTEN.fetch_add(1, Ordering::Relaxed);
        let beside = path.with_extension(format!("{}-{number}.part", std::process::id()));
        let written = fs::File::create_new(&beside)
            .and_then(|mut file| file.write_all(text.as_bytes()))
            .and_then(|()| fs::rename(&beside, &path));
        if written.is_err() {
            let _ = fs::remove_file(&beside);
        }
        written
    }

    fn path(&self, heading: &Heading) -> PathBuf {
        self.folder.join(format!("{}.json", hash(&format!("{}\n{}", heading.id, heading.source.text))))
    }
}

/// FNV-1a over 128 bits, in hexadecimal digits: a name for a text, and a sum that notices a torn file.
fn hash(text: &str) -> String {
    let prime: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    let start: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    format!("{:032x}", text.bytes().fold(start, |hash, byte| (hash ^ u128::from(byte)).wrapping_mul(prime)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::Contents;
    use crate::examine::Finding;

    fn cache(name: &str) -> Cache {
        let folder = std::env::temp_dir().join(format!("carom-cache-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        Cache { folder }
    }

    fn heading() -> Heading {
        Contents::shipped().headings.remove(0)
    }

    fn report() -> Report {
        let style = StyleReport { style: "exact".to_owned(), sets: 10, variants: 4, ..StyleReport::default() };
        let mark = MarkCount { part: "a".to_owned(), id: "M1a".to_owned(), won: 3, lost: 2 };
        let coverage = Coverage { marks: vec![mark], scripts: 5, faults: Vec::new() };
        Report { styles: vec![style], findings: Vec::new(), coverage }
    }

    #[test]
    fn what_was_sound_is_remembered_and_what_was_not_is_not() {
        let (cache, heading) = (cache("sound"), heading());
        assert_eq!(cache.sound(&heading), None);
        let amiss = Report { findings: vec![Finding::new("amiss", "", "")], ..report() };
        cache.remember(&heading, &amiss);
        assert_eq!(cache.sound(&heading), None);
        cache.remember(&heading, &report());
        assert_eq!(cache.sound(&heading), Some(report()));
        let _ = fs::remove_dir_all(&cache.folder);
    }

    #[test]
    fn another_text_another_carom_and_a_torn_file_count_for_nothing() {
        let (cache, heading) = (cache("torn"), heading());
        cache.remember(&heading, &report());
        let mut changed = heading.clone();
        changed.source = crate::diagnostic::Source::new(&*heading.source.file, format!("{} ", heading.source.text));
        assert_eq!(cache.sound(&changed), None);
        let path = cache.path(&heading);
        let whole = fs::read_to_string(&path).unwrap();
        // The file of this question under the name of another one.
        fs::write(cache.path(&changed), &whole).unwrap();
        assert_eq!(cache.sound(&changed), None);
        let of_another = |entry: String| format!("{}\n{entry}", hash(&entry));
        let entry = whole.split_once('\n').unwrap().1;
        let half = &whole[..whole.len() / 2];
        let flipped = whole.replacen("\"variants\":4", "\"variants\":5", 1);
        let older = of_another(entry.replacen(BUILD, "0", 1));
        let idle = of_another(entry.replacen("\"lost\":2", "\"lost\":0", 1));
        for text in ["", "{}", half, &flipped, &older, &idle, "\u{0}\n\u{0}"] {
            assert_ne!(text, whole);
            fs::write(&path, text).unwrap();
            assert_eq!(cache.sound(&heading), None, "{text}");
        }
        cache.remember(&heading, &report());
        assert_eq!(cache.sound(&heading), Some(report()));
        let left: Vec<_> = fs::read_dir(&cache.folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert!(left.iter().all(|name| name.to_string_lossy().ends_with(".json")), "{left:?}");
        let _ = fs::remove_dir_all(&cache.folder);
    }
}
