//! Fractions of tenths, hundredths or thousandths, which say no more than the decimal: `303/1000`.

use super::accuracy::Written;
use crate::expr::Expr;

impl Written {
    /// The decimal that such a fraction is.
    pub(super) fn over_power_of_ten(expr: &Expr) -> Option<Written> {
        let Expr::Quotient(above, below) = expr else { return None };
        let (above, below) = (digits(above)?, digits(below)?);
        let noughts = below.strip_prefix('1').filter(|rest| rest.bytes().all(|sign| sign == b'0'))?.len();
        let padded = format!("{above:0>width$}", width = noughts + 1);
        let (whole, decimals) = padded.split_at(padded.len() - noughts);
        Written::text(&format!("{whole}.{decimals}")).filter(|_| noughts > 0)
    }
}

/// A whole number that is not negative, as it is written.
fn digits(expr: &Expr) -> Option<String> {
    let Expr::Number(number) = expr else { return None };
    Some(number.to_string()).filter(|written| written.bytes().all(|sign| sign.is_ascii_digit()))
}
