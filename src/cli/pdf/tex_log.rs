//! The first error in what a TeX engine says.

/// An error as TeX reports it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TexError {
    /// Its words, in one line.
    pub message: String,
    /// The file in which TeX was reading, as TeX calls it; empty if it was in none.
    pub file: String,
    /// The line of that file, from 1; 0 if it was in none.
    pub line: usize,
    /// What TeX had read of that line, to where it stopped.
    pub read: String,
    /// The last thing that it expanded, if the error is inside a command: `\vv ->\wrong `.
    pub inside: Option<String>,
}

/// Reads what was said under `-file-line-error`: errors begin with the place, or with `!` where there is none.
pub fn first_error(said: &str) -> Option<TexError> {
    let lines: Vec<&str> = said.lines().collect();
    let (at, mut error) = lines.iter().enumerate().find_map(|(at, line)| Some((at, heading(line)?)))?;
    let after = &lines[at + 1..];
    if error.message.contains("Error:") {
        for more in after.iter().map_while(|line| continued(line)) {
            error.message = format!("{} {more}", error.message);
        }
    }
    // What follows belongs to it, up to an error elsewhere. LaTeX leaves the place of some to the stop behind them.
    for line in after {
        if let Some(next) = heading(line) {
            if error.line == 0 {
                (error.file, error.line) = (next.file, next.line);
            } else if next.line != error.line {
                break;
            }
        }
        if let Some((number, read)) = context(line) {
            error.read = read.to_owned();
            if error.line == 0 {
                error.line = number;
            }
            break;
        }
    }
    error.inside = after.first().filter(|line| line.contains("->")).map(|line| line.to_string());
    Some(error)
}

/// The start of an error: `./sheet.tex:4: Undefined control sequence.` or `! Emergency stop.`
fn heading(line: &str) -> Option<TexError> {
    if let Some(message) = line.strip_prefix('!') {
        return said(message, "", 0);
    }
    // A place may have colons of its own, as in `C:/texmf/geometry.sty:12: `.
    line.match_indices(':').find_map(|(colon, _)| {
        let (file, rest) = (&line[..colon], &line[colon + 1..]);
        let (number, message) = rest.split_once(": ")?;
        let ending = file.rsplit_once('.')?.1;
        let is_file = (1..=4).contains(&ending.len()) && ending.bytes().all(|byte| byte.is_ascii_alphanumeric());
        said(message, file, number.parse().ok().filter(|_| is_file)?)
    })
}

fn said(message: &str, file: &str, line: usize) -> Option<TexError> {
    let message = message.trim();
    let is_error = !message.is_empty() && !message.starts_with("==>");
    let file = file.strip_prefix("./").unwrap_or(file).to_owned();
    is_error.then(|| TexError { message: message.to_owned(), file, line, ..TexError::default() })
}

/// The words of an error of LaTeX in its next line: behind blanks, or behind the name of a package as `(babel)    found.`
fn continued(line: &str) -> Option<&str> {
    let words = match line.strip_prefix('(') {
        Some(line) => line.split_once(')')?.1,
        None => line,
    };
    words.starts_with("  ").then(|| words.trim()).filter(|words| !words.is_empty())
}

/// `l.4 A \vv`: how far the line had been read.
fn context(line: &str) -> Option<(usize, &str)> {
    let (number, read) = line.strip_prefix("l.")?.split_once(' ')?;
    Some((number.parse().ok()?, read))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(message: &str, file: &str, line: usize, read: &str, inside: Option<&str>) -> TexError {
        let [message, file, read] = [message, file, read].map(str::to_owned);
        TexError { message, file, line, read, inside: inside.map(str::to_owned) }
    }

    #[test]
    fn carom_knows_where_tex_stopped() {
        let cases = [
            (
                "(./bad.tex (/usr/share/texmf/article.cls\nDocument Class: article 2022/07/02\n)\nNo file bad.aux.\n\
                 ./bad.tex:4: Undefined control sequence.\n\\vv ->\\wrong \n             {x}\nl.4 A \\vv\n         {} and\n\
                 ./bad.tex:4:  ==> Fatal error occurred, no output PDF file produced!\n",
                error("Undefined control sequence.", "bad.tex", 4, "A \\vv", Some("\\vv ->\\wrong ")),
            ),
            (
                "! LaTeX Error: File `tikz.sty' not found.\n\nType X to quit\n\n./a.tex:3: Emergency stop.\n<read *> \n\n\
                 l.3 \\begin\n",
                error("LaTeX Error: File `tikz.sty' not found.", "a.tex", 3, "\\begin", None),
            ),
            (
                "./a.tex:4: LaTeX Error: Unicode character Ω (U+2126)\n               not set up for use with LaTeX.\n\n\
                 See the LaTeX manual.\n ...  \n\nl.4 a Ω\n         b\n",
                error(
                    "LaTeX Error: Unicode character Ω (U+2126) not set up for use with LaTeX.",
                    "a.tex",
                    4,
                    "a Ω",
                    None,
                ),
            ),
            (
                "C:/texmf/babel.sty:4357: Package babel Error: Unknown option `klingon'. Either\n\
                 (babel)                you misspelled it.\n\nl.4357 \\ProcessOptions*\n                       \n",
                error(
                    "Package babel Error: Unknown option `klingon'. Either you misspelled it.",
                    "C:/texmf/babel.sty",
                    4357,
                    "\\ProcessOptions*",
                    None,
                ),
            ),
            (
                "! I can't find the format file `pdflatex.fmt'!\n",
                error("I can't find the format file `pdflatex.fmt'!", "", 0, "", None),
            ),
        ];
        for (said, expected) in cases {
            assert_eq!(first_error(said), Some(expected));
        }
    }

    #[test]
    fn talk_is_no_error() {
        for said in ["", "This is pdfTeX\n(./a.tex)\n", "Package: geometry 2020/01/02 v5.9\n12:30: o'clock\n", "!\n"] {
            assert_eq!(first_error(said), None, "{said}");
        }
    }
}
