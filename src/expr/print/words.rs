//! Plain words made safe for LaTeX, HTML and a terminal, whoever wrote them.

/// Words for LaTeX's text, readable by pdfLaTeX with its default fonts.
///
/// What those fonts lack becomes its nearest neighbour or `?`; control and direction characters go. All else is printed as it
/// was typed: two hyphens are two hyphens, and no dash.
///
/// ```
/// use carom::expr::print;
/// assert_eq!(print::words_latex(r"\input{x} & 50%"), r"\textbackslash{}input\{x\} \& 50\%");
/// assert_eq!(print::words_latex("Set 3--4"), r"Set 3-\kern0pt -4");
/// ```
pub fn words_latex(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    write_words_latex(text, &mut out);
    out
}

pub(super) fn write_words_latex(text: &str, out: &mut String) {
    let mut rest = text;
    while let Some(c) = past_plain(&mut rest, out) {
        match latex_command(c) {
            Some(command) => apart(command, out),
            None if c.is_whitespace() => out.push(' '),
            None if is_hidden(c) => {}
            None if c.is_ascii() || is_composed(c) => apart(c.encode_utf8(&mut [0; 4]), out),
            None => out.push('?'),
        }
    }
}

/// Adds what comes next, so that TeX makes no other sign of it and of what is before it: of two hyphens a dash, of two
/// apostrophes or commas a quote. Empty braces would do for pdfTeX; LuaTeX looks through them.
fn apart(next: &str, out: &mut String) {
    let first = next.chars().next().filter(|first| matches!(first, '-' | '\'' | ',' | '`'));
    let is_pair = first.is_some_and(|first| out.ends_with(first));
    if is_pair || (matches!(next, LESS | GREATER) && out.ends_with(next)) {
        out.push_str(r"\kern0pt ");
    }
    out.push_str(next);
}

/// Of two of these LuaTeX makes one quote of a French book.
const LESS: &str = r"\textless{}";
const GREATER: &str = r"\textgreater{}";

/// Has LaTeX `?` for a letter of these words?
///
/// ```
/// use carom::expr::print::latex_lacks;
/// assert!(latex_lacks("Владимир") && !latex_lacks("Zoë Müller"));
/// ```
pub fn latex_lacks(text: &str) -> bool {
    let is_had =
        |c: char| c.is_ascii() || c.is_whitespace() || is_hidden(c) || is_composed(c) || latex_command(c).is_some();
    !text.chars().all(is_had)
}

/// Words for HTML, in text and in attribute values.
pub fn words_html(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    write_words_html(text, &mut out);
    out
}

pub(super) fn write_words_html(text: &str, out: &mut String) {
    let mut rest = text;
    while let Some(c) = past_plain(&mut rest, out) {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.extend(shown(c)),
        }
    }
}

/// Letters, digits, blanks and full stops, by their bytes: most of what is written, and the same everywhere.
static PLAIN: [bool; 256] = {
    let mut plain = [false; 256];
    let mut byte = 0;
    while byte < 128 {
        plain[byte] = matches!(byte as u8, b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b' ' | b'.');
        byte += 1;
    }
    plain
};

/// Takes over the plain characters that come next, and then takes off one other.
fn past_plain(rest: &mut &str, out: &mut String) -> Option<char> {
    let length = rest.bytes().position(|byte| !PLAIN[usize::from(byte)]).unwrap_or(rest.len());
    let (plain, other) = rest.split_at(length);
    out.push_str(plain);
    let mut characters = other.chars();
    let next = characters.next();
    *rest = characters.as_str();
    next
}

/// Words for a terminal, without the characters that could command it.
pub fn words_unicode(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    write_words_unicode(text, &mut out);
    out
}

pub(super) fn write_words_unicode(text: &str, out: &mut String) {
    out.extend(text.chars().filter_map(shown));
}

/// A character as it may be shown, if it may.
fn shown(c: char) -> Option<char> {
    match c {
        ' '..='~' | '\u{a0}' => Some(c),
        _ if c.is_whitespace() => Some(' '),
        _ => (!is_hidden(c)).then_some(c),
    }
}

/// Control characters, and those that turn the direction of writing, join, or show nothing at all.
fn is_hidden(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}')
        || matches!(c, '\u{2060}'..='\u{206f}' | '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{fff0}'..='\u{fffb}')
        || matches!(c, '\u{e000}'..='\u{f8ff}' | '\u{e0000}'..)
}

fn latex_command(c: char) -> Option<&'static str> {
    Some(match c {
        '\\' => r"\textbackslash{}",
        '{' => r"\{",
        '}' => r"\}",
        // In mathematics, for the text's own dollar is in a font of bitmaps.
        '$' => r"$\$$",
        '&' => r"\&",
        '#' => r"\#",
        '_' => r"\_",
        '%' => r"\%",
        // Of these the usual fonts have only accents and quotes that turn; the typewriter has them as they are typed, but for
        // the tilde, which is had from mathematics. It is never bold or italic, since not every TeX has that.
        '^' => r"{\normalfont\ttfamily\symbol{94}}",
        '~' => r"$\sim$",
        '"' => r"{\normalfont\ttfamily\symbol{34}}",
        '`' => r"{\normalfont\ttfamily\`{}}",
        '<' => LESS,
        '>' => GREATER,
        '|' => r"\textbar{}",
        '”' | '»' | '„' => "''",
        '“' | '«' => "``",
        // By itself and by name, for `?` before it would make an inverted question mark.
        '‘' => r"{}\textquoteleft{}",
        '’' | '′' => "'",
        // In braces, for after a line break or an item it would open an option.
        '[' => "{[}",
        ']' => "{]}",
        '\u{a0}' | '\u{202f}' => "~",
        '–' => "--",
        '—' => "---",
        '‐' | '‑' => "-",
        '−' => "$-$",
        '×' => r"$\times$",
        '÷' => r"$\div$",
        '·' => r"$\cdot$",
        '±' => r"$\pm$",
        '≤' => r"$\leq$",
        '≥' => r"$\geq$",
        '≠' => r"$\neq$",
        '≈' => r"$\approx$",
        '°' => r"$^\circ$",
        '½' => r"$\frac{1}{2}$",
        '¼' => r"$\frac{1}{4}$",
        '¾' => r"$\frac{3}{4}$",
        '¹' => "$^1$",
        '²' => "$^2$",
        '³' => "$^3$",
        '⁻' => "$^-$",
        '√' => r"$\surd$",
        '∑' => r"$\sum$",
        '£' => r"$\pounds$",
        '€' => "EUR",
        '…' => r"\ldots{}",
        '•' => r"$\bullet$",
        'ð' | 'đ' => "d",
        'Ð' | 'Đ' => "D",
        'þ' => "th",
        'Þ' => "Th",
        'ą' => "a",
        'ę' => "e",
        'Ą' => "A",
        'Ę' => "E",
        _ => return greek(c),
    })
}

/// Greek letters, which the text's own fonts lack, from those of mathematics: in angles, and in names.
fn greek(c: char) -> Option<&'static str> {
    Some(match c {
        'Α' | 'Ά' => "A",
        'Β' => "B",
        'Γ' => r"$\Gamma$",
        'Δ' => r"$\Delta$",
        'Ε' | 'Έ' => "E",
        'Ζ' => "Z",
        'Η' | 'Ή' => "H",
        'Θ' => r"$\Theta$",
        'Ι' | 'Ί' | 'Ϊ' => "I",
        'Κ' => "K",
        'Λ' => r"$\Lambda$",
        'Μ' => "M",
        'Ν' => "N",
        'Ξ' => r"$\Xi$",
        'Ο' | 'Ό' => "O",
        'Π' => r"$\Pi$",
        'Ρ' => "P",
        'Σ' => r"$\Sigma$",
        'Τ' => "T",
        'Υ' | 'Ύ' | 'Ϋ' => "Y",
        'Φ' => r"$\Phi$",
        'Χ' => "X",
        'Ψ' => r"$\Psi$",
        'Ω' | 'Ώ' => r"$\Omega$",
        'α' => r"$\alpha$",
        'ά' => r"$\acute\alpha$",
        'β' => r"$\beta$",
        'γ' => r"$\gamma$",
        'δ' => r"$\delta$",
        'ε' | 'ϵ' => r"$\epsilon$",
        'έ' => r"$\acute\epsilon$",
        'ζ' => r"$\zeta$",
        'η' => r"$\eta$",
        'ή' => r"$\acute\eta$",
        'θ' | 'ϑ' => r"$\theta$",
        'ι' | 'ϊ' => r"$\iota$",
        'ί' | 'ΐ' => r"$\acute\iota$",
        'κ' => r"$\kappa$",
        'λ' => r"$\lambda$",
        'μ' | 'µ' => r"$\mu$",
        'ν' => r"$\nu$",
        'ξ' => r"$\xi$",
        'ο' => "o",
        'ό' => r"\'o",
        'π' => r"$\pi$",
        'ρ' => r"$\rho$",
        'σ' => r"$\sigma$",
        'ς' => r"$\varsigma$",
        'τ' => r"$\tau$",
        'υ' | 'ϋ' => r"$\upsilon$",
        'ύ' | 'ΰ' => r"$\acute\upsilon$",
        'φ' | 'ϕ' => r"$\phi$",
        'χ' => r"$\chi$",
        'ψ' => r"$\psi$",
        'ω' => r"$\omega$",
        'ώ' => r"$\acute\omega$",
        _ => return None,
    })
}

/// Letters that pdfLaTeX's oldest fonts compose from a letter and an accent.
fn is_composed(c: char) -> bool {
    matches!(c, 'À'..='Ö' | 'Ø'..='Ý' | 'ß'..='ö' | 'ø'..='ý' | 'ÿ' | '¡' | '¿')
        || "ĀāĂăĆćĈĉĊċČčĎďĒēĔĕĖėĚěĜĝĞğĠġĤĥĨĩĪīĬĭİıĴĵŁłĹĺĽľŃńŇňŌōŎŏŐőŒœŔŕŘřŚśŜŝŞşŠšŢţŤťŨũŪūŬŭŮůŰűŴŵŶŷŸŹźŻżŽž".contains(c)
}
