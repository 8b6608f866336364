//! A sheet to draw on, which remembers what is taken so that no label covers anything.

use std::fmt::Write;

/// A rectangle that is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Area {
    pub fn around(x: f64, y: f64, half: f64) -> Area {
        Area { left: x - half, top: y - half, right: x + half, bottom: y + half }
    }

    pub fn meets(&self, other: &Area) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    pub fn lies_in(&self, other: &Area) -> bool {
        self.left >= other.left && self.right <= other.right && self.top >= other.top && self.bottom <= other.bottom
    }
}

/// A colour by what it is for; on a dark page the darker ones are made lighter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    Ink,
    Faint,
    Grid,
    Orange,
    Sky,
    Green,
    Blue,
    Vermilion,
    Purple,
}

impl Tone {
    /// Of a series by its place among all.
    pub const SERIES: [Tone; 7] =
        [Tone::Blue, Tone::Vermilion, Tone::Green, Tone::Purple, Tone::Orange, Tone::Sky, Tone::Ink];

    fn class(self) -> &'static str {
        match self {
            Tone::Ink => "ink",
            Tone::Faint => "faint",
            Tone::Grid => "grid",
            Tone::Orange => "orange",
            Tone::Sky => "sky",
            Tone::Green => "green",
            Tone::Blue => "blue",
            Tone::Vermilion => "vermilion",
            Tone::Purple => "purple",
        }
    }

    fn colour(self) -> &'static str {
        match self {
            Tone::Ink => "#111111",
            Tone::Faint => "#555555",
            Tone::Grid => "#dddddd",
            Tone::Orange => "#e69f00",
            Tone::Sky => "#56b4e9",
            Tone::Green => "#009e73",
            Tone::Blue => "#0072b2",
            Tone::Vermilion => "#d55e00",
            Tone::Purple => "#cc79a7",
        }
    }
}

/// What a dark page changes.
const STYLE: &str = "<style>.paper{fill:#fff}@media(prefers-color-scheme:dark){.paper{fill:#16181c}\
.ink{--c:#f2f2f2}.faint{--c:#b4b8c0}.grid{--c:#3a3e46}.blue{--c:#4aa3df}.vermilion{--c:#f08030}.green{--c:#2cc198}\
.f.ink,.f.faint,.f.grid,.f.blue,.f.vermilion,.f.green{fill:var(--c)}\
.s.ink,.s.faint,.s.grid,.s.blue,.s.vermilion,.s.green{stroke:var(--c)}}</style>";

/// A mark of a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    Circle,
    Square,
    Triangle,
    Diamond,
    Down,
    Cross,
    Plus,
    Star,
}

impl Shape {
    /// Of a series by its place among all.
    pub const SERIES: [Shape; 8] = [
        Shape::Circle,
        Shape::Square,
        Shape::Triangle,
        Shape::Diamond,
        Shape::Down,
        Shape::Cross,
        Shape::Plus,
        Shape::Star,
    ];
}

/// Where a text hangs on its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// The sheet.
pub struct Canvas {
    pub width: f64,
    pub height: f64,
    body: String,
    /// Where nothing more may be written.
    pub taken: Vec<Area>,
    /// Those of them that hold words.
    pub written: Vec<Area>,
    /// Those of them that hold marks.
    pub marked: Vec<Area>,
}

impl Canvas {
    pub fn new(width: f64, height: f64) -> Canvas {
        Canvas { width, height, body: String::new(), taken: Vec::new(), written: Vec::new(), marked: Vec::new() }
    }

    /// How wide a text is at most in any sans-serif letters of this size.
    pub fn width_of(text: &str, size: f64) -> f64 {
        0.6 * size * text.chars().count() as f64
    }

    pub fn take(&mut self, area: Area) {
        self.taken.push(area);
    }

    pub fn line(&mut self, from: (f64, f64), to: (f64, f64), tone: Tone, width: f64, dashes: &str) {
        let dashes = if dashes.is_empty() { String::new() } else { format!(r#" stroke-dasharray="{dashes}""#) };
        self.put(format_args!(
            r#"<path class="s {}" d="M{:.1} {:.1}L{:.1} {:.1}" stroke="{}" stroke-width="{width}"{dashes}/>"#,
            tone.class(),
            from.0,
            from.1,
            to.0,
            to.1,
            tone.colour()
        ));
    }

    /// A rectangle with a colour of its own, the same on any page.
    pub fn cell(&mut self, area: Area, colour: &str) {
        self.put(format_args!(
            r#"<rect x="{:.1}" y="{:.1}" width="{:.1}" height="{:.1}" fill="{colour}"/>"#,
            area.left,
            area.top,
            area.right - area.left,
            area.bottom - area.top
        ));
    }

    pub fn bar(&mut self, area: Area, tone: Tone) {
        self.put(format_args!(
            r#"<rect class="f {}" x="{:.1}" y="{:.1}" width="{:.1}" height="{:.1}" fill="{}"/>"#,
            tone.class(),
            area.left,
            area.top,
            area.right - area.left,
            area.bottom - area.top,
            tone.colour()
        ));
    }

    pub fn text(&mut self, at: (f64, f64), anchor: Anchor, size: f64, tone: Tone, text: &str) {
        let class = format!(r#" class="f {}""#, tone.class());
        self.words(at, anchor, size, &class, tone.colour(), "", text);
    }

    /// A text whose colour stays as it is on a dark page: one that stands on a coloured cell.
    pub fn text_on_cell(&mut self, at: (f64, f64), size: f64, colour: &str, text: &str) {
        self.words(at, Anchor::Middle, size, "", colour, "", text);
    }

    pub fn strong(&mut self, at: (f64, f64), anchor: Anchor, size: f64, text: &str) {
        self.words(at, anchor, size, r#" class="f ink""#, Tone::Ink.colour(), r#" font-weight="bold""#, text);
    }

    /// A text that is read from below.
    pub fn upright(&mut self, at: (f64, f64), size: f64, text: &str) {
        let turn = format!(r#" transform="rotate(-90 {:.1} {:.1})""#, at.0, at.1);
        self.words(at, Anchor::Middle, size, r#" class="f ink""#, Tone::Ink.colour(), &turn, text);
    }

    #[allow(clippy::too_many_arguments)]
    fn words(&mut self, at: (f64, f64), anchor: Anchor, size: f64, class: &str, colour: &str, more: &str, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        self.put(format_args!(
            r#"<text x="{:.1}" y="{:.1}" font-size="{size}" text-anchor="{anchor}"{class} fill="{colour}"{more}>{}</text>"#,
            at.0,
            at.1,
            escaped(text)
        ));
    }

    pub fn mark(&mut self, (x, y): (f64, f64), shape: Shape, tone: Tone, half: f64) {
        let (class, colour) = (tone.class(), tone.colour());
        if shape == Shape::Circle {
            self.put(format_args!(r#"<circle class="f {class}" cx="{x:.1}" cy="{y:.1}" r="{half}" fill="{colour}"/>"#));
            return;
        }
        let at = |points: &[(f64, f64)]| {
            let mut path = String::new();
            for (place, (dx, dy)) in points.iter().enumerate() {
                let letter = if place == 0 { 'M' } else { 'L' };
                // Nothing is written that could fail: it is a string.
                let _ = write!(path, "{letter}{:.1} {:.1}", x + half * dx, y + half * dy);
            }
            path
        };
        let open = match shape {
            Shape::Cross => Some(at(&[(-0.9, -0.9), (0.9, 0.9)]) + &at(&[(-0.9, 0.9), (0.9, -0.9)])),
            Shape::Plus => Some(at(&[(-1.1, 0.0), (1.1, 0.0)]) + &at(&[(0.0, -1.1), (0.0, 1.1)])),
            _ => None,
        };
        if let Some(path) = open {
            self.put(format_args!(
                r#"<path class="s {class}" d="{path}" stroke="{colour}" stroke-width="2.2" fill="none"/>"#
            ));
            return;
        }
        let path = match shape {
            Shape::Square => at(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)]),
            Shape::Triangle => at(&[(0.0, -1.15), (1.05, 0.85), (-1.05, 0.85)]),
            Shape::Down => at(&[(0.0, 1.15), (1.05, -0.85), (-1.05, -0.85)]),
            Shape::Diamond => at(&[(0.0, -1.3), (1.0, 0.0), (0.0, 1.3), (-1.0, 0.0)]),
            _ => at(&[
                (0.0, -1.4),
                (0.32, -0.44),
                (1.33, -0.43),
                (0.52, 0.17),
                (0.82, 1.13),
                (0.0, 0.55),
                (-0.82, 1.13),
                (-0.52, 0.17),
                (-1.33, -0.43),
                (-0.32, -0.44),
            ]),
        };
        self.put(format_args!(r#"<path class="f {class}" d="{path}Z" fill="{colour}"/>"#));
    }

    fn put(&mut self, piece: std::fmt::Arguments) {
        let _ = self.body.write_fmt(piece);
        self.body.push('\n');
    }

    /// The picture, with a sentence for those who cannot see it.
    pub fn finish(self, words: &str) -> String {
        format!(
            concat!(
                r#"<svg xmlns="http://www.w3.org/2000/svg" class="chart" role="img" aria-label="{}" "#,
                r#"viewBox="0 0 {:.0} {:.0}" font-family="system-ui, 'DejaVu Sans', Arial, sans-serif" fill="none">"#,
                "\n{}\n<rect class=\"paper\" width=\"{:.0}\" height=\"{:.0}\" fill=\"#fff\"/>\n{}</svg>\n"
            ),
            escaped(words),
            self.width,
            self.height,
            STYLE,
            self.width,
            self.height,
            self.body
        )
    }
}

/// As it stands in a text or an attribute of SVG.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
