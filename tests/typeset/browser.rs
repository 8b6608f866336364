//! Chromium without a window: it sets a page, measures it and prints it.

use std::fs;
use std::path::{Path, PathBuf};

use carom::render::RenderedFile;
use serde::Deserialize;

use super::chromium::chromium;
use super::said;

/// What is to be seen of a page in a window of some width.
#[derive(Debug, Deserialize)]
pub struct Seen {
    /// Of the window, in pixels.
    pub width: u32,
    /// How far the contents reach to the right.
    pub reach: u32,
    /// How wide the part of the window is that shows them.
    pub window: u32,
    /// How many formulas there are.
    pub formulas: usize,
    /// How many fractions in them.
    pub fractions: usize,
    /// What is wrong with formulas.
    pub faults: Vec<String>,
    /// The diagrams in order.
    pub diagrams: Vec<Picture>,
    /// The margins that the page asks of a printer, with their units: top, right, bottom, left.
    pub margins: [String; 4],
}

/// The ink of a diagram; lengths in it are shares of its width, y downwards.
#[derive(Debug, Deserialize)]
pub struct Picture {
    /// Points along each stroke.
    pub lines: Vec<Vec<[f64; 2]>>,
    /// Two corners of each letter.
    pub letters: Vec<[[f64; 2]; 2]>,
    /// How wide it is on the screen, in pixels.
    pub width: f64,
}

/// A page in windows of several widths, the widest first.
pub fn seen(folder: &Path, page: &RenderedFile) -> Vec<Seen> {
    let text = serde_json::to_string(&page.contents).unwrap().replace('<', "\\u003c");
    let around = format!(
        "<!DOCTYPE html><meta charset=\"utf-8\"><body>\
         <script type=\"application/json\" id=\"page\">{text}</script>\n<script>{}</script>",
        include_str!("measure.js")
    );
    let path = folder.join(format!("measured-{}", page.name));
    fs::write(&path, around).unwrap();
    let mut chromium = chromium(folder);
    // for the clock of the page, which stands still while it works
    chromium.args(["--window-size=1600,1200", "--virtual-time-budget=20000", "--dump-dom"]);
    let told = said(chromium.arg(format!("file://{}", path.display())));
    let json = told.split("id=\"measured\">").nth(1).and_then(|rest| rest.split("</script>").next());
    serde_json::from_str(json.unwrap_or_else(|| panic!("{}: not measured", page.name))).unwrap()
}

/// A page as the browser prints it, its lines as long as its margins leave them.
///
/// The browser cuts off what reaches into a margin of the sheet. So that it can be found, the room at the sides is given
/// to the contents instead.
pub fn printed(folder: &Path, page: &RenderedFile, [_, right, _, left]: &[String; 4]) -> PathBuf {
    let open = format!(
        "<style>@page {{ margin-left: 0; margin-right: 0 }} @media print {{ html {{ margin: 0 {right} 0 {left} }} }}</style>\n</body>"
    );
    let (path, pdf) = (folder.join(&page.name), folder.join(&page.name).with_extension("pdf"));
    fs::write(&path, page.contents.replace("</body>", &open)).unwrap();
    let mut chromium = chromium(folder);
    chromium.arg("--no-pdf-header-footer").arg(format!("--print-to-pdf={}", pdf.display()));
    said(chromium.arg(format!("file://{}", path.display())));
    pdf
}
