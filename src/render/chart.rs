//! Charts of a report as SVG, in the colour and the letters of the page around them: black on white paper they lose nothing.
//!
//! The figures of each stand in a table beside it, for those who do not see it and for those who want them.

use crate::expr::print::words_html;

/// Wide enough for a phone without being made smaller.
const WIDTH: usize = 330;

/// Letters of this size are read there.
const LETTERS: usize = 11;

/// The height of the tallest column.
const TALL: usize = 110;

/// Columns: how many students have how much of the paper, in tenths of it.
pub(super) fn columns(counts: &[usize; 10]) -> String {
    let most = counts.iter().copied().max().unwrap_or(0).max(1);
    let step = WIDTH / 10;
    let floor = TALL + 16;
    let mut body = String::new();
    for (place, count) in counts.iter().enumerate() {
        let (left, height) = (place * step, TALL * count / most);
        if *count > 0 {
            body.push_str(&rectangle(left + 3, floor - height, step - 6, height));
            body.push_str(&text(left + step / 2, floor - height - 4, "middle", &count.to_string()));
        }
        // The shares between which the column stands; the last one belongs to it.
        let anchor = if place == 0 { "start" } else { "middle" };
        body.push_str(&text(left, floor + 14, anchor, &(10 * place).to_string()));
    }
    body.push_str(&text(WIDTH, floor + 14, "end", "100"));
    body.push_str(&format!(r#"<path d="M0 {floor}H{WIDTH}" stroke="currentColor"/>"#));
    let students: usize = counts.iter().sum();
    let plural = if students == 1 { "" } else { "s" };
    let words =
        format!("Columns: how many of {students} student{plural} earned how much of the paper, in tenths of it");
    picture(&words, floor + 20, &body)
}

/// A bar for each question: the share of its marks that was won.
pub(super) fn bars(rows: &[(&str, usize)]) -> String {
    const ROW: usize = 18;
    let letters = rows.iter().map(|(label, _)| label.chars().count()).max().unwrap_or(0).clamp(1, 12);
    let (left, room) = (letters * 7 + 8, WIDTH - letters * 7 - 8 - 44);
    let mut body = String::new();
    for (place, (label, per_cent)) in rows.iter().enumerate() {
        let top = place * ROW;
        let width = room * (*per_cent).min(100) / 100;
        body.push_str(&text(left - 6, top + 13, "end", &shortened(label, 12)));
        body.push_str(&rectangle(left, top + 3, width, ROW - 6));
        body.push_str(&text(left + width + 5, top + 13, "start", &format!("{per_cent}%")));
    }
    let bottom = rows.len() * ROW;
    body.push_str(&format!(r#"<path d="M{left} 0V{bottom}" stroke="currentColor"/>"#));
    picture("Bars: the share of the marks of each question that was won", bottom + 2, &body)
}

/// A bar in the cell of a table, beside its figure, which says the same.
pub(super) fn bar(per_cent: usize) -> String {
    format!(
        concat!(
            r#"<svg class="bar" aria-hidden="true" viewBox="0 0 100 10" preserveAspectRatio="none">"#,
            r#"<rect width="{}" height="10" fill="currentColor" fill-opacity="0.6"/>"#,
            r#"<path d="M0 9.5H100" stroke="currentColor" stroke-width="1"/></svg>"#
        ),
        per_cent.min(100)
    )
}

fn shortened(label: &str, most: usize) -> String {
    match label.char_indices().nth(most) {
        Some(_) => label.chars().take(most - 1).chain(['…']).collect(),
        None => label.to_owned(),
    }
}

fn rectangle(left: usize, top: usize, width: usize, height: usize) -> String {
    format!(
        r#"<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="currentColor" fill-opacity="0.6" stroke="currentColor"/>"#
    )
}

fn text(x: usize, y: usize, anchor: &str, words: &str) -> String {
    format!(r#"<text x="{x}" y="{y}" text-anchor="{anchor}" fill="currentColor">{}</text>"#, words_html(words))
}

fn picture(words: &str, height: usize, body: &str) -> String {
    format!(
        r#"<svg class="chart" role="img" aria-label="{}" viewBox="0 0 {WIDTH} {height}" font-size="{LETTERS}" fill="none">{body}</svg>"#,
        words_html(words)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers of an attribute, in order.
    fn all(picture: &str, attribute: &str) -> Vec<usize> {
        let opening = format!(" {attribute}=\"");
        let pieces = picture.split(&opening).skip(1);
        pieces.map(|rest| rest.split('"').next().unwrap().parse().unwrap()).collect()
    }

    #[test]
    fn columns_are_as_tall_as_their_counts() {
        let picture = columns(&[0, 0, 1, 0, 0, 2, 0, 4, 0, 0]);
        assert_eq!(all(&picture, "height"), [27, 55, 110]);
        assert!(picture.contains("of 7 students") && picture.contains(">4</text>"));
        assert_eq!(all(&columns(&[0; 10]), "height"), [0; 0]);
        assert!(columns(&[0, 0, 0, 1, 0, 0, 0, 0, 0, 0]).contains("of 1 student earned"));
    }

    #[test]
    fn bars_stay_on_the_sheet_whatever_a_question_is_called() {
        let picture = bars(&[("1", 50), ("2", 100), ("3", 0)]);
        let widths = all(&picture, "width");
        assert_eq!((widths[0], widths[1] / 2, widths[2]), (widths[1] / 2, widths[0], 0));
        let long = bars(&[("rest/<speeds>-and-directions", 100)]);
        assert!(
            all(&long, "x")[1] + all(&long, "width")[0] + 44 <= WIDTH && long.contains("rest/&lt;speed…"),
            "{long}"
        );
    }
}
