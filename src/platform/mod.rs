//! What differs between the web and the desktop.
