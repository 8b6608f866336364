//! Drawings as TikZ.

use super::source::Source;
use super::{Drawing, Point, Section, Style};
use crate::expr::print;

/// The drawing as a `tikzpicture`, in ems of the letters around it. Each style of stroke is a command of the
/// format's preamble, which reads a path as TikZ's own commands do; `\Label` puts the middle of its words at a point.
pub fn tikz(drawing: &Drawing) -> String {
    let Drawing { strokes, labels, low, high } = drawing;
    let mut out = Source::for_marks(strokes.len() + labels.len());
    out.put("\\begin{tikzpicture}[diagram={").point(*high - *low, ",").put("}]\n");
    let at = |out: &mut Source, before: &str, point: Point| {
        out.put(before).put("(").point(point - *low, ",").put(")");
    };
    for stroke in strokes {
        at(&mut out, command(stroke.style), stroke.from);
        for piece in &stroke.pieces {
            match *piece {
                Section::Line(end) => at(&mut out, " -- ", end),
                Section::Curve(one, other, end) => {
                    at(&mut out, " .. controls ", one);
                    at(&mut out, " and ", other);
                    at(&mut out, " .. ", end);
                }
            }
        }
        out.put(if stroke.style == Style::Filled { " -- cycle;\n" } else { ";\n" });
    }
    for label in labels {
        at(&mut out, "\\Label at ", label.centre);
        out.put(" {").put(&print::text_latex(&label.text)).put("};\n");
    }
    out.put("\\end{tikzpicture}");
    out.finish()
}

fn command(style: Style) -> &'static str {
    match style {
        Style::Rim => "\\Rim ",
        Style::Centres => "\\Centres ",
        Style::Velocity => "\\Velocity ",
        Style::Thin => "\\Thin ",
        Style::Dashed => "\\Dashed ",
        Style::Filled => "\\Filled ",
    }
}
