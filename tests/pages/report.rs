//! The report on a class, as a page.

use std::fs;

use carom::mark::report::Names;
use carom::render::Formats;

use super::class::report;

#[test]
fn carom_knows_the_report_on_a_class() {
    let formats = Formats::shipped().unwrap();
    let accept = std::env::var_os("CAROM_ACCEPT").is_some();
    report(Names::Shown, |class| {
        let page = formats.report("html", class).unwrap().unwrap();
        let path = super::folder().join(&page.name);
        if accept {
            fs::write(&path, &page.contents).unwrap();
        }
        let known = fs::read_to_string(&path).unwrap_or_default();
        assert!(known == page.contents, "{} differs: CAROM_ACCEPT=1 writes it anew", path.display());
    });
}

#[test]
fn a_report_fetches_nothing_runs_nothing_and_shows_names_as_they_are() {
    let formats = Formats::shipped().unwrap();
    report(Names::Shown, |class| {
        let page = formats.report("html", class).unwrap().unwrap().contents;
        for fetched in ["<link", "<script", "@import", "url(", " src=", "@font-face"] {
            assert!(!page.contains(fetched), "{fetched}");
        }
        assert!(page.contains("&lt;script&gt;alert(1)") && page.contains("Ada Lovelace"));
    });
}

#[test]
fn a_report_without_names_has_none_and_nothing_that_a_student_typed() {
    let formats = Formats::shipped().unwrap();
    report(Names::LeftOut, |class| {
        let page = formats.report("html", class).unwrap().unwrap().contents;
        assert!(page.contains("Student 1") && page.contains("Student 2"));
        for name in ["Ada", "Lovelace", "alert(1)", "over there", "it bounces"] {
            assert!(!page.contains(name), "{name}");
        }
    });
}
