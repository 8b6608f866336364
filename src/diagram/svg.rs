//! Drawings as SVG.

use super::source::Source;
use super::{Diagram, Drawing, Point, Section, Style};
use crate::expr::print;

/// Units of the picture to an em, so that its letters have a size that every browser sets.
const SCALE: f64 = 10.0;

/// The diagram as an `svg` element as wide as its letters ask for, its words as the text alternative. It takes the
/// colour and the letters of the page around it; each style of stroke is a class of its name.
pub fn svg(diagram: &Diagram) -> String {
    let Drawing { strokes, labels, low, high } = &diagram.drawing;
    let size = *high - *low;
    let mut out = Source::for_marks(strokes.len() + labels.len());
    out.put(r#"<svg class="diagram" role="img" aria-label=""#);
    out.put(&print::words_html(&diagram.words));
    out.put(r#"" width=""#).length(size.x).put(r#"em" height=""#).length(size.y);
    out.put(r#"em" viewBox="0 0 "#).point(size * SCALE, " ").put(r#"" font-size="10" fill="none" stroke="none">"#);
    let place = |point: Point| Point::new((point.x - low.x) * SCALE, (high.y - point.y) * SCALE);
    for stroke in strokes {
        out.put(look(stroke.style)).put(r#" d="M"#).point(place(stroke.from), " ");
        for piece in &stroke.pieces {
            match *piece {
                Section::Line(end) => out.put("L").point(place(end), " "),
                Section::Curve(one, other, end) => out
                    .put("C")
                    .point(place(one), " ")
                    .put(" ")
                    .point(place(other), " ")
                    .put(" ")
                    .point(place(end), " "),
            };
        }
        out.put(if stroke.style == Style::Filled { "Z\"/>" } else { "\"/>" });
    }
    for label in labels {
        // The middle between the feet of brackets and the tops of raised digits, above the line that letters stand on.
        let foot = place(label.centre) + Point::new(0.0, 0.3 * SCALE);
        out.put(r#"<text x=""#).length(foot.x).put(r#"" y=""#).length(foot.y);
        out.put(r#"" text-anchor="middle" fill="currentColor">"#).put(&print::text_svg(&label.text)).put("</text>");
    }
    out.put("</svg>");
    out.finish()
}

/// The beginning of a path: the class of its style, and how it looks without a style sheet.
fn look(style: Style) -> &'static str {
    match style {
        Style::Rim => r#"<path class="rim" stroke="currentColor" stroke-width="0.7""#,
        Style::Centres => {
            r#"<path class="centres" stroke="currentColor" stroke-width="0.5" stroke-dasharray="6 2 1 2""#
        }
        Style::Velocity => r#"<path class="velocity" stroke="currentColor" stroke-width="1.1""#,
        Style::Thin => r#"<path class="thin" stroke="currentColor" stroke-width="0.5""#,
        Style::Dashed => r#"<path class="dashed" stroke="currentColor" stroke-width="0.5" stroke-dasharray="2 2""#,
        Style::Filled => r#"<path class="filled" fill="currentColor""#,
    }
}
