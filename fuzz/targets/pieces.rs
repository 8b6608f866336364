//! Answers made of pieces of answers: each byte chooses one, so that formulas, words and commands come whole.
#![no_main]

mod chance;
#[path = "../../tests/strange/laws.rs"]
mod laws;

/// What answers are made of; nothing is longer than it must be.
const PIECES: [&str; 163] = [
    "0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "12", "39", "43", "61", "90", "180", ".", "·", ",", "…",
    "2.78", "46.1", "0.233", "4√39/9", "10/43", "4i+j", "i-3j", "u(1-e)/2", "9mu²/4", "3√3/5", "2:3", "2v+3w", "4u",
    " ", "  ", "\n", ";", ":", "=", "≈", "<", ">", "≤", "≠", "+", "-", "−", "–", "*", "×", "/", "÷", "^", "²", "³", "⁻¹",
    "(", ")", "[", "]", "{", "}", "|", "√", "∛", "°", "%", "'", "!", "?", "½", "¾", "⅓", "\u{307}", "±", "~", "_", "&",
    "i", "j", "u", "m", "e", "v", "w", "v_A", "θ", "theta", "alpha", "tanβ", "mu", "x", "A", "B", "V", "I", "l", "O",
    "sin", "cos", "tan", "arctan", "tan⁻¹", "sin²", "sqrt", "root", "pi", "π", "abs", "deg", "rad", "m/s", "ms^-1", "J",
    "Ns", "kJ", "cm/s", "to the line of centres", "along the line of centres", "perpendicular to", "to the tangent",
    "from BA", "parallel to", "at rest", "or", "and", "so", "because", "not", "speed", "gradient", "is", "over",
    "times", "squared", "square root of", "recurring", "(3 s.f.)", "to 3sf", "approximately", "bananas", "Q", "e-3",
    "3e2", "\\frac{", "}{", "\\sqrt{", "\\begin{pmatrix}", "\\\\", "\\end{pmatrix}", "\\dot{3}", "\\left(", "\\right)",
    "\\mathbf{i}", "\\text{", "$", "\\theta", "10^", "1 000", "1,000", "(a)", "S",
];

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Some((number, chosen)) = bytes.split_first() {
        let text: String = chosen.iter().map(|byte| PIECES[usize::from(*byte) % PIECES.len()]).collect();
        laws::hold(*number, &text);
    }
});
