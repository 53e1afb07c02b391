//! The top bar and its menus.

pub mod figures_menu;
pub mod file_menu;
pub mod help_menu;
pub mod top_bar;
