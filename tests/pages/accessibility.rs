//! The pages as a browser shows them: axe-core finds no fault in them, in either scheme, on a desk or on a phone.

use std::fs;
use std::path::{Path, PathBuf};

use carom::bank::Bank;
use carom::diagnostic::render_all;
use carom::generate::reference;
use carom::mark::report::Names;
use carom::paper::{Dealer, Edition, Paper, compose};
use carom::render::{Formats, RenderedFile};

use super::chromium::chromium;
use super::on_both::on_both;

/// How a page is looked at.
#[derive(Clone, Copy, Debug)]
struct Look {
    width: u32,
    dark: bool,
}

const DESK: Look = Look { width: 1200, dark: false };
const DESK_AT_NIGHT: Look = Look { width: 1200, dark: true };
const PHONE: Look = Look { width: 360, dark: false };
const PHONE_AT_NIGHT: Look = Look { width: 360, dark: true };
const LOOKS: [Look; 4] = [DESK, DESK_AT_NIGHT, PHONE, PHONE_AT_NIGHT];

/// What runs within the page: axe-core, and then the report to the frame around it, a fault a line.
const REPORT: &str = r#"addEventListener("load", async () => {
    const found = await axe.run(document, { resultTypes: ["violations"] });
    const lines = found.violations.map(({ id, help, nodes }) =>
        `${id}: ${help}: ${nodes.length} of them, first ${nodes[0].html.slice(0, 200).replaceAll("\n", " ")}`);
    const page = document.documentElement;
    if (page.scrollWidth > innerWidth) lines.push(`too-wide: ${page.scrollWidth} of ${innerWidth} pixels`);
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    parent.postMessage([`${innerWidth} ${dark}`, ...lines].join("\n"), "*");
})"#;

/// The program that looks for faults, where `.ci/run` has put it.
fn axe() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/axe/node_modules/axe-core/axe.min.js");
    fs::read_to_string(&path)
        .unwrap_or_else(|fault| panic!("{}: {fault}: `.ci/run` says how npm installs axe-core there", path.display()))
}

/// A folder of its own, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("accessibility").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// The faults of each page. They stand in a frame one after another, since no window of a browser is as narrow as a phone.
fn faults_of_each(folder: &Path, pages: &[&str], look: Look) -> Vec<Vec<String>> {
    let scripts = format!("<script>{}</script><script>{REPORT}</script></body>", axe());
    for (place, page) in pages.iter().enumerate() {
        fs::write(folder.join(format!("page-{place}.html")), page.replace("</body>", &scripts)).unwrap();
    }
    let frame = format!(
        r#"<!DOCTYPE html><script>
            let place = 0;
            onmessage = ({{ data }}) => {{
                document.documentElement.dataset[`found${{place}}`] = data;
                if (++place < {}) document.querySelector("iframe").src = `page-${{place}}.html`;
            }};
        </script><iframe src="page-0.html" width="{}" height="900" style="border: 0"></iframe>"#,
        pages.len(),
        look.width
    );
    let path = folder.join("frame.html");
    fs::write(&path, frame).unwrap();
    let mut chromium = chromium(folder);
    chromium.args(["--hide-scrollbars", "--window-size=1300,1000", "--virtual-time-budget=600000", "--dump-dom"]);
    chromium.arg(format!("--blink-settings=preferredColorScheme={}", if look.dark { 0 } else { 1 }));
    chromium.arg(format!("file://{}", path.display()));
    let output = chromium.output().unwrap();
    let dom = String::from_utf8_lossy(&output.stdout);
    let faults = |place: usize| {
        let said = dom.split(&format!("data-found{place}=\"")).nth(1).and_then(|rest| rest.split('"').next());
        let said = said.unwrap_or_else(|| panic!("{look:?}: {}", String::from_utf8_lossy(&output.stderr)));
        let mut lines = said.lines().map(str::to_owned);
        assert_eq!(lines.next(), Some(format!("{} {}", look.width, look.dark)), "not looked at as was meant");
        lines.collect()
    };
    (0..pages.len()).map(faults).collect()
}

/// The faults of pages, each with the page that has it and the look; so many pages are shown by one browser.
fn faults(name: &str, pages: &[RenderedFile], together: usize, looks: &[Look]) -> Vec<String> {
    let of_look = |look: &Look| pages.chunks(together).map(|pages| (pages, *look)).collect::<Vec<_>>();
    let visits: Vec<_> = looks.iter().flat_map(of_look).enumerate().collect();
    let found = on_both(&visits, |(visit, (pages, look))| {
        let contents: Vec<&str> = pages.iter().map(|page| page.contents.as_str()).collect();
        let found = faults_of_each(&folder(&format!("{name}-{visit}")), &contents, *look);
        let placed = |(page, faults): (&RenderedFile, Vec<String>)| {
            faults.into_iter().map(|fault| format!("{} {look:?}: {fault}", page.name)).collect::<Vec<_>>()
        };
        pages.iter().zip(found).flat_map(placed).collect::<Vec<_>>()
    });
    found.concat()
}

/// The shipped pages of a paper.
fn pages(paper: &Paper) -> Vec<RenderedFile> {
    let pages = Formats::shipped().unwrap().render("html", paper).unwrap();
    assert_eq!(pages.len(), 3);
    pages
}

/// The faults of every shipped question, with its own numbers and with fresh ones in each style that it offers.
fn faults_of_bank(name: &str, edition: Edition, look: Look) -> Vec<String> {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let mut paper =
        Paper { title: "Every question".into(), code: "KV7-3QX".into(), seed: Some(7), edition, ..Paper::default() };
    for question in &bank.questions {
        let own = reference(question).unwrap_or_else(|_| panic!("{}: reference", question.id));
        paper.questions.push(compose(question, &own, paper.questions.len() + 1));
        for style in &question.styles {
            let variant = Dealer::new(7, Some(style.name)).next(question).expect("a variant");
            paper.questions.push(compose(question, &variant, paper.questions.len() + 1));
        }
    }
    faults(name, &pages(&paper), 1, &[look])
}

#[test]
#[ignore = "needs Chromium and axe-core, which `.ci/run` installs"]
fn carom_knows_pages_of_the_whole_bank_that_axe_finds_no_fault_in_on_a_desk() {
    assert_eq!(faults_of_bank("bank-on-a-desk", Edition::default(), DESK), Vec::<String>::new());
}

#[test]
#[ignore = "needs Chromium and axe-core, which `.ci/run` installs"]
fn carom_knows_pages_of_the_whole_bank_that_axe_finds_no_fault_in_on_a_phone_at_night() {
    assert_eq!(faults_of_bank("bank-on-a-phone", Edition::default(), PHONE_AT_NIGHT), Vec::<String>::new());
}

#[test]
#[ignore = "needs Chromium and axe-core, which `.ci/run` installs"]
fn carom_knows_pages_of_the_whole_bank_that_axe_finds_no_fault_in_in_large_print_on_a_phone() {
    let edition = Edition { large_print: true, ..Edition::default() };
    assert_eq!(faults_of_bank("bank-in-large-print", edition, PHONE), Vec::<String>::new());
}

#[test]
#[ignore = "needs Chromium and axe-core, which `.ci/run` installs"]
fn carom_knows_editions_that_axe_finds_no_fault_in() {
    let found = faults("plain", &pages(&super::paper::paper()), 3, &[DESK_AT_NIGHT, PHONE]);
    assert!(found.is_empty(), "{}", found.join("\n"));
    let edition = Edition { large_print: true, answer_space: true, ..Edition::default() };
    let large = pages(&Paper { edition, ..super::paper::paper() });
    let found = faults("large", &large, 3, &[PHONE, PHONE_AT_NIGHT]);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
#[ignore = "needs Chromium and axe-core, which `.ci/run` installs"]
fn carom_knows_pages_of_feedback_that_axe_finds_no_fault_in() {
    let formats = Formats::shipped().unwrap();
    super::class::pages(|students| {
        let pages: Vec<_> = students.iter().map(|page| formats.feedback("html", page).unwrap().unwrap()).collect();
        assert!(pages.len() > 1);
        let found = faults("feedback", &pages, pages.len(), &LOOKS);
        assert!(found.is_empty(), "{}", found.join("\n"));
    });
}

#[test]
#[ignore = "needs Chromium and axe-core, which `.ci/run` installs"]
fn carom_knows_reports_and_pages_of_a_class_that_axe_finds_no_fault_in() {
    let formats = Formats::shipped().unwrap();
    let mut pages = formats.class("html", &super::class()).unwrap().unwrap();
    assert_eq!(pages.len(), 4);
    for names in [Names::Shown, Names::LeftOut] {
        super::class::report(names, |class| pages.extend(formats.report("html", class).unwrap()));
    }
    let found = faults("class", &pages, pages.len(), &LOOKS);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
#[ignore = "needs Chromium and axe-core, which `.ci/run` installs"]
fn a_fault_of_a_page_is_seen() {
    let sound = Formats::shipped().unwrap().render("html", &super::paper::paper()).unwrap().remove(0).contents;
    let cases = [
        ("", None),
        (r#"<img src="sphere.png">"#, Some("image-alt: ")),
        (r#"<p style="color: #888; background: #fff">Find the speed of the sphere.</p>"#, Some("color-contrast: ")),
        (r#"<p style="width: 400px">Find the speed of the sphere.</p>"#, Some("too-wide: ")),
    ];
    let pages = cases.map(|(planted, _)| sound.replace("</main>", &format!("{planted}</main>")));
    let found = faults_of_each(&folder("planted"), &pages.each_ref().map(String::as_str), PHONE);
    for ((planted, expected), found) in cases.into_iter().zip(found) {
        assert_eq!(found.len(), usize::from(expected.is_some()), "{planted}: {found:?}");
        assert!(expected.is_none_or(|id| found[0].starts_with(id)), "{planted}: {found:?}");
    }
}
