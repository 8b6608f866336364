//! Drawings as SVG.

use std::fmt::Write;

use super::short::Short;
use super::{Diagram, Drawing, Point, Section, Style};
use crate::expr::print;

/// Units of the picture to an em, so that its letters have a size that every browser sets.
const SCALE: f64 = 10.0;

/// The diagram as an `svg` element as wide as its letters ask for, its words as the text alternative. It takes the
/// colour and the letters of the page around it; each style of stroke is a class of its name.
pub fn svg(diagram: &Diagram) -> String {
    let Drawing { strokes, labels, low, high } = &diagram.drawing;
    let [width, height] = [high.x - low.x, high.y - low.y];
    let mut out = format!(
        r#"<svg class="diagram" role="img" aria-label="{}" width="{}em" height="{}em" viewBox="0 0 {} {}" font-size="10" fill="none" stroke="none">"#,
        print::words_html(&diagram.words).replace('"', "&quot;"),
        Short(width),
        Short(height),
        Short(width * SCALE),
        Short(height * SCALE),
    );
    let at = |point: Point| Place(Point::new((point.x - low.x) * SCALE, (high.y - point.y) * SCALE));
    for stroke in strokes {
        let (class, look) = look(stroke.style);
        // Writing to a string cannot fail.
        let _ = write!(out, r#"<path class="{class}" {look} d="M{}"#, at(stroke.from));
        for piece in &stroke.pieces {
            let _ = match *piece {
                Section::Line(end) => write!(out, "L{}", at(end)),
                Section::Curve(one, other, end) => write!(out, "C{} {} {}", at(one), at(other), at(end)),
            };
        }
        out.push_str(if stroke.style == Style::Filled { "Z\"/>" } else { "\"/>" });
    }
    for label in labels {
        // The middle of a line of letters lies about a third of an em above the line they stand on.
        let foot = Place(at(label.centre).0 + Point::new(0.0, 0.33 * SCALE));
        let _ = write!(
            out,
            r#"<text x="{}" y="{}" text-anchor="middle" fill="currentColor">{}</text>"#,
            Short(foot.0.x),
            Short(foot.0.y),
            print::text_svg(&label.text)
        );
    }
    out.push_str("</svg>");
    out
}

/// The class of a style and how it looks without a style sheet.
fn look(style: Style) -> (&'static str, &'static str) {
    match style {
        Style::Rim => ("rim", r#"stroke="currentColor" stroke-width="0.7""#),
        Style::Centres => ("centres", r#"stroke="currentColor" stroke-width="0.5" stroke-dasharray="6 2 1 2""#),
        Style::Velocity => ("velocity", r#"stroke="currentColor" stroke-width="1.1""#),
        Style::Thin => ("thin", r#"stroke="currentColor" stroke-width="0.5""#),
        Style::Dashed => ("dashed", r#"stroke="currentColor" stroke-width="0.5" stroke-dasharray="2 2""#),
        Style::Filled => ("filled", r#"fill="currentColor""#),
    }
}

/// A point as a path has it.
struct Place(Point);

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", Short(self.0.x), Short(self.0.y))
    }
}
