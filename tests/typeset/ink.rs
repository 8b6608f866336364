//! What a page of a PDF shows: the outlines of its letters and its lines, read from what poppler draws.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use carom::diagram::Point;

use super::said;

/// A rectangle with sides along the page's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Its least x and y.
    pub low: Point,
    /// Its greatest.
    pub high: Point,
}

impl Area {
    /// The least that holds all points; none of none.
    pub fn around(points: impl IntoIterator<Item = Point>) -> Option<Area> {
        points.into_iter().map(|at| Area { low: at, high: at }).reduce(Area::and)
    }

    /// The least that holds both.
    pub fn and(self, other: Area) -> Area {
        let low = Point { x: self.low.x.min(other.low.x), y: self.low.y.min(other.low.y) };
        let high = Point { x: self.high.x.max(other.high.x), y: self.high.y.max(other.high.y) };
        Area { low, high }
    }

    /// So much larger on each side.
    pub fn grown(self, by: f64) -> Area {
        let low = Point { x: self.low.x - by, y: self.low.y - by };
        let high = Point { x: self.high.x + by, y: self.high.y + by };
        Area { low, high }
    }

    /// Is the point in it?
    pub fn holds(self, at: Point) -> bool {
        self.low.x <= at.x && at.x <= self.high.x && self.low.y <= at.y && at.y <= self.high.y
    }

    /// Is all of the other in it?
    pub fn covers(self, other: Area) -> bool {
        self.holds(other.low) && self.holds(other.high)
    }

    /// Do they share a place?
    pub fn meets(self, other: Area) -> bool {
        let apart = |low: f64, high: f64, least: f64, most: f64| high < least || most < low;
        !apart(self.low.x, self.high.x, other.low.x, other.high.x)
            && !apart(self.low.y, self.high.y, other.low.y, other.high.y)
    }

    /// Its middle.
    pub fn middle(self) -> Point {
        Point { x: (self.low.x + self.high.x) / 2.0, y: (self.low.y + self.high.y) / 2.0 }
    }
}

/// What is drawn and written in one picture or on one page.
#[derive(Clone, Debug, Default)]
pub struct Ink {
    /// The lines, in the order in which they are drawn: points along each, close together.
    pub lines: Vec<Vec<Point>>,
    /// The box of each letter.
    pub letters: Vec<Area>,
}

/// Points along a cubic curve, its beginning left out.
pub fn along([from, first, second, to]: [Point; 4]) -> impl Iterator<Item = Point> {
    const STEPS: u32 = 32;
    (1..=STEPS).map(move |step| {
        let t = f64::from(step) / f64::from(STEPS);
        let s = 1.0 - t;
        let mixed = |from: f64, first: f64, second: f64, to: f64| {
            s * s * s * from + 3.0 * s * s * t * first + 3.0 * s * t * t * second + t * t * t * to
        };
        Point { x: mixed(from.x, first.x, second.x, to.x), y: mixed(from.y, first.y, second.y, to.y) }
    })
}

/// The ink of a page of a PDF, in points from its corner at the left and the top, y downwards.
pub fn ink(pdf: &Path, page: usize) -> Ink {
    let page = page.to_string();
    read(&said(
        Command::new("pdftocairo").args(["-svg", "-noshrink", "-nocenter", "-f", &page, "-l", &page]).arg(pdf).arg("-"),
    ))
}

/// An SVG as poppler writes them: letters are named outlines, used at places; lines are paths.
fn read(svg: &str) -> Ink {
    let mut ink = Ink::default();
    let mut outlines: BTreeMap<&str, Vec<Point>> = BTreeMap::new();
    let mut named = None;
    for tag in svg.split('<') {
        match tag.split([' ', '>']).next().unwrap_or_default() {
            "symbol" | "g" if attribute(tag, "id").is_some_and(|id| id.starts_with("glyph")) => {
                named = attribute(tag, "id");
            }
            "/symbol" | "/g" | "/clipPath" | "/defs" => named = None,
            // what is cut out is not drawn
            "clipPath" => named = Some("clip"),
            "path" => {
                let lines = path(attribute(tag, "d").unwrap_or_default());
                match named {
                    Some(name) => outlines.entry(name).or_default().extend(lines.into_iter().flatten()),
                    None => ink.lines.extend(joined(lines, matrix(tag))),
                }
            }
            "use" => {
                let number = |name: &str| attribute(tag, name).and_then(|text| text.parse::<f64>().ok()).unwrap_or(0.0);
                let by = Point { x: number("x"), y: number("y") };
                let name = attribute(tag, "xlink:href").unwrap_or_default().trim_start_matches('#');
                let outline = outlines.get(name).into_iter().flatten();
                ink.letters.extend(Area::around(outline.map(|at| Point { x: at.x + by.x, y: at.y + by.y })));
            }
            _ => {}
        }
    }
    ink
}

/// A path in one piece, turned to its place; poppler ends a closed one with the point that it began with.
fn joined(lines: Vec<Vec<Point>>, [a, b, c, d, e, f]: [f64; 6]) -> Option<Vec<Point>> {
    let points = lines.into_iter().flatten();
    let turned = points.map(|at| Point { x: a * at.x + c * at.y + e, y: b * at.x + d * at.y + f });
    Some(turned.collect::<Vec<_>>()).filter(|line| line.len() > 1)
}

fn attribute<'t>(tag: &'t str, name: &str) -> Option<&'t str> {
    let (_, rest) = tag.split_once(&format!(" {name}=\""))?;
    Some(rest.split_once('"')?.0)
}

fn matrix(tag: &str) -> [f64; 6] {
    let told = attribute(tag, "transform").and_then(|told| told.strip_prefix("matrix(")?.strip_suffix(')'));
    let numbers: Option<Vec<f64>> =
        told.and_then(|told| told.split([',', ' ']).map(|text| text.parse().ok()).collect());
    numbers.and_then(|numbers| numbers.try_into().ok()).unwrap_or([1.0, 0.0, 0.0, 1.0, 0.0, 0.0])
}

/// The pieces of a path, points along each.
fn path(told: &str) -> Vec<Vec<Point>> {
    let mut lines: Vec<Vec<Point>> = Vec::new();
    let mut words = told.split_whitespace();
    while let Some(word) = words.next() {
        let mut point =
            || -> Option<Point> { Some(Point { x: words.next()?.parse().ok()?, y: words.next()?.parse().ok()? }) };
        match word {
            "M" => lines.push(point().into_iter().collect()),
            "L" => {
                let line = lines.last_mut().expect("a line begins somewhere");
                let (from, to) = (line[line.len() - 1], point().expect("a place"));
                let third = |at: f64| Point { x: from.x + at * (to.x - from.x), y: from.y + at * (to.y - from.y) };
                line.extend(along([from, third(1.0 / 3.0), third(2.0 / 3.0), to]));
            }
            "C" => {
                let line = lines.last_mut().expect("a line begins somewhere");
                let [first, second, to] = [point(), point(), point()].map(|at| at.expect("a place"));
                line.extend(along([line[line.len() - 1], first, second, to]));
            }
            "Z" => {
                let line = lines.last_mut().expect("a line begins somewhere");
                line.push(line[0]);
            }
            other => panic!("poppler draws `{other}` in {told}"),
        }
    }
    lines
}

#[test]
fn a_page_is_read_as_poppler_draws_it() {
    let svg = r##"<defs><g><symbol overflow="visible" id="glyph0-1"><path d="M 0 0 L 2 -6 L 4 0 Z M 0 0 "/></symbol></g>
        <clipPath id="clip1"><path d="M 0 0 L 90 90 Z"/></clipPath></defs><g id="surface1">
        <path style="fill:none;" d="M 0 0 L 10 5 " transform="matrix(2,0,0,-1,1,20)"/>
        <use xlink:href="#glyph0-1" x="10" y="30"/></g>"##;
    let ink = read(svg);
    let corner = |x: f64, y: f64| Point { x, y };
    assert_eq!(ink.letters, [Area { low: corner(10.0, 24.0), high: corner(14.0, 30.0) }]);
    assert_eq!(ink.lines.len(), 1);
    let line = &ink.lines[0];
    assert!((line.first(), line.last()) == (Some(&corner(1.0, 20.0)), Some(&corner(21.0, 15.0))), "{line:?}");
}
