//! The app: panels, viewports, handles.
