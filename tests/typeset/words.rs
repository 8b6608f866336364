//! The words of a PDF, page by page, and where they stand.

use std::path::Path;
use std::process::Command;

use carom::diagram::Point;

use super::ink::Area;
use super::said;

/// A word on a page, its box in points from the corner at the left and the top.
#[derive(Clone, Debug)]
pub struct Word {
    /// What it says.
    pub text: String,
    /// Where it stands: as wide as its letters, as high as its font.
    pub area: Area,
}

/// The words of each page.
pub fn words(pdf: &Path) -> Vec<Vec<Word>> {
    read(&said(Command::new("pdftotext").arg("-bbox").arg(pdf).arg("-")))
}

fn read(told: &str) -> Vec<Vec<Word>> {
    let mut pages = Vec::new();
    for line in told.lines().map(str::trim) {
        if line.starts_with("<page ") {
            pages.push(Vec::new());
        } else if line.starts_with("<word ") {
            let page = pages.last_mut().expect("a word stands on a page");
            page.extend(word(line));
        }
    }
    pages
}

fn word(line: &str) -> Option<Word> {
    let number = |name: &str| line.split_once(&format!("{name}=\""))?.1.split('"').next()?.parse().ok();
    let low = Point { x: number("xMin")?, y: number("yMin")? };
    let high = Point { x: number("xMax")?, y: number("yMax")? };
    let text = line.split_once('>')?.1.trim_end_matches("</word>").to_owned();
    Some(Word { text, area: Area { low, high } })
}

/// How many lines the words fill.
pub fn lines(words: &[&Word]) -> usize {
    // less than a line apart, more than a superscript
    const APART: f64 = 7.0;
    let mut feet: Vec<f64> = words.iter().map(|word| word.area.high.y).collect();
    feet.sort_by(f64::total_cmp);
    feet.chunk_by(|above, below| below - above < APART).count()
}

#[test]
fn the_words_of_a_page_are_read() {
    let told = "<page width=\"595\" height=\"841\">\n\
                <word xMin=\"10\" yMin=\"20.5\" xMax=\"30\" yMax=\"30\">A</word>\n\
                <word xMin=\"31\" yMin=\"20.5\" xMax=\"60\" yMax=\"31\">smooth</word>\n</page>\n\
                <page width=\"595\" height=\"841\">\n\
                <word xMin=\"10\" yMin=\"40\" xMax=\"30\" yMax=\"50\">sphere</word>\n</page>";
    let pages = read(told);
    assert_eq!(pages.iter().flatten().map(|word| word.text.as_str()).collect::<Vec<_>>(), ["A", "smooth", "sphere"]);
    assert_eq!(pages[0][1].area.low, Point { x: 31.0, y: 20.5 });
    assert_eq!(lines(&pages[0].iter().collect::<Vec<_>>()), 1);
    assert_eq!(lines(&pages.iter().flatten().collect::<Vec<_>>()), 2);
}
