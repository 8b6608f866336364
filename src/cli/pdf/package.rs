//! Where a file that LaTeX does not find comes from.

/// Packages by the files they bring, with what they belong to in TeX Live and in Debian. Only what sheets are likely to
/// use: of the others the search of TeX Live knows more than any list.
const KNOWN: [(&[&str], &str, &str); 8] = [
    (
        &["amsmath", "geometry", "fancyhdr", "array", "longtable", "graphicx", "babel", "hyperref", "tabularx"],
        "collection-latex",
        "texlive-latex-base",
    ),
    (&["amssymb", "amsfonts"], "amsfonts", "texlive-latex-base"),
    (&["tikz", "pgf", "pgfplots", "pgfcore"], "pgf", "texlive-pictures"),
    (&["lmodern"], "lm", "lmodern"),
    (
        &["microtype", "booktabs", "xcolor", "fontspec", "unicode-math", "setspace", "parskip", "caption"],
        "collection-latexrecommended",
        "texlive-latex-recommended",
    ),
    (
        &["enumitem", "tcolorbox", "titlesec", "lastpage", "cancel", "mdframed", "multirow", "tabulary"],
        "collection-latexextra",
        "texlive-latex-extra",
    ),
    (&["siunitx", "physics", "mhchem", "units", "siunits"], "siunitx", "texlive-science"),
    (
        &["newtxtext", "newtxmath", "libertine", "ebgaramond", "sourcesanspro"],
        "collection-fontsextra",
        "texlive-fonts-extra",
    ),
];

/// What to install so that a file is found: `tikz.sty`, on a system.
pub fn install(file: &str, system: &str) -> String {
    let name = file.split('.').next().unwrap_or(file);
    let known = KNOWN.iter().find(|(names, _, _)| names.contains(&name));
    match (system, known) {
        ("windows", _) => {
            format!("install `{name}` with the MiKTeX Console, or with `tlmgr install {name}` in TeX Live")
        }
        ("macos", Some((_, bundle, _))) => format!("install it with `sudo tlmgr install {bundle}`"),
        ("macos", None) => format!("install it with `sudo tlmgr install {name}`"),
        (_, Some((_, bundle, package))) => {
            format!("install it: on Debian or Ubuntu `sudo apt install {package}`, elsewhere `tlmgr install {bundle}`")
        }
        (_, None) => {
            format!(
                "install it: on Debian or Ubuntu `sudo apt install texlive-latex-extra`, elsewhere `tlmgr install {name}`"
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_where_a_package_comes_from() {
        for (file, system, said) in [
            ("tikz.sty", "linux", "apt install texlive-pictures"),
            ("tikz.sty", "macos", "tlmgr install pgf"),
            ("tikz.sty", "windows", "MiKTeX Console"),
            ("siunitx.sty", "linux", "texlive-science"),
            ("nobody-knows.sty", "linux", "tlmgr install nobody-knows"),
        ] {
            assert!(install(file, system).contains(said), "{file} on {system}: {}", install(file, system));
        }
    }
}
