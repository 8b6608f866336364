//! The command line: the only rooms that read arguments, touch the disk or print.

mod template_folder;

pub use template_folder::read_templates;
