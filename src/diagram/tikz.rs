//! Drawings as TikZ.

use std::fmt::Write;

use super::short::Short;
use super::{Drawing, Point, Section, Style};
use crate::expr::print;

/// The drawing as a `tikzpicture`, in ems of the letters around it. Each style of stroke is a command of the
/// format's preamble, which reads a path as TikZ's own commands do; `\Label` puts the middle of its words at a point.
pub fn tikz(drawing: &Drawing) -> String {
    let Drawing { strokes, labels, low, high } = drawing;
    let size = *high - *low;
    let mut out = format!("\\begin{{tikzpicture}}[diagram={{{},{}}}]\n", Short(size.x), Short(size.y));
    let at = |point: Point| Place(point - *low);
    for stroke in strokes {
        // Writing to a string cannot fail.
        let _ = write!(out, "\\{} {}", command(stroke.style), at(stroke.from));
        for piece in &stroke.pieces {
            let _ = match *piece {
                Section::Line(end) => write!(out, " -- {}", at(end)),
                Section::Curve(one, other, end) => {
                    write!(out, " .. controls {} and {} .. {}", at(one), at(other), at(end))
                }
            };
        }
        out.push_str(if stroke.style == Style::Filled { " -- cycle;\n" } else { ";\n" });
    }
    for label in labels {
        let _ = writeln!(out, "\\Label at {} {{{}}};", at(label.centre), print::text_latex(&label.text));
    }
    out.push_str("\\end{tikzpicture}");
    out
}

fn command(style: Style) -> &'static str {
    match style {
        Style::Rim => "Rim",
        Style::Centres => "Centres",
        Style::Velocity => "Velocity",
        Style::Thin => "Thin",
        Style::Dashed => "Dashed",
        Style::Filled => "Filled",
    }
}

struct Place(Point);

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "({},{})", Short(self.0.x), Short(self.0.y))
    }
}
