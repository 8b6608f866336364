//! The series of versions of carom, such as 0.1, within which what one version wrote another reads.

/// The series that a version is of; none of what is no version.
pub(crate) fn series(version: &str) -> Option<(u64, u64)> {
    let mut numbers = version.split('.').map(|number| number.parse().ok());
    Some((numbers.next()??, numbers.next()??))
}

/// Is a version of a later series than this one? What it wrote may say what this one would pass over.
pub(crate) fn is_of_later_series(version: &str) -> bool {
    series(version) > series(env!("CARGO_PKG_VERSION"))
}
