//! The page that a student gets back, in every format.

use std::fs;

use carom::render::Formats;

use super::class::pages;

#[test]
fn carom_knows_the_page_that_a_student_gets_back() {
    let formats = Formats::shipped().unwrap();
    let accept = std::env::var_os("CAROM_ACCEPT").is_some();
    pages(|pages| {
        for (format, _) in formats.list() {
            let page = formats.feedback(format, &pages[0]).unwrap().unwrap();
            assert!(page.name.starts_with("ada-lovelace."), "{}", page.name);
            let path = super::folder().join(page.name.replace("ada-lovelace", "feedback"));
            if accept {
                fs::write(&path, &page.contents).unwrap();
            }
            let known = fs::read_to_string(&path).unwrap_or_default();
            assert!(known == page.contents, "{} differs: CAROM_ACCEPT=1 writes it anew", path.display());
        }
    });
}

#[test]
fn carom_knows_that_students_may_type_anything() {
    let formats = Formats::shipped().unwrap();
    pages(|pages| {
        let page = |format: &str| formats.feedback(format, &pages[1]).unwrap().unwrap();
        let (html, latex) = (page("html").contents, page("latex").contents);
        assert!(!html.contains("<script") && html.contains("&lt;script&gt;alert(1)"), "{html}");
        assert!(!latex.contains(r"\input{") && latex.matches(r"\end{document}").count() == 1, "{latex}");
        for page in [html, latex, page("text").contents] {
            assert!(!page.contains(&"9".repeat(301)), "nobody reads so many figures");
        }
        assert_eq!(page("html").name, "input-etc-passwd-script-alert-1-script.html");
    });
}
