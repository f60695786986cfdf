//! Turns the list of views into the type of a view on a page.

/// Declares `ViewSpec`, an enum with a case per view, and the functions that all views share.
///
/// JSON: an object with its name and its settings, such as `{"lobes": {"theta_i": [60]}}`; its name alone stands for
/// the settings that it has by default.
macro_rules! view_list {
    ($($(#[$doc:meta])* $view:ident($spec:ty),)*) => {
        /// A view on a page: its kind and its settings.
        #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
        #[serde(rename_all = "kebab-case", remote = "Self")]
        pub enum ViewSpec {
            $($(#[$doc])* $view($spec),)*
        }

        /// Kinds of views, by their names in files.
        #[derive(Clone, Copy, serde::Deserialize)]
        #[serde(rename_all = "kebab-case")]
        enum ViewKind {
            $($view,)*
        }

        impl ViewKind {
            fn with_defaults(self) -> ViewSpec {
                match self {
                    $(Self::$view => ViewSpec::$view(Default::default()),)*
                }
            }
        }

        impl ViewSpec {
            /// Views with their default settings, one of each kind.
            pub fn defaults() -> Vec<Self> {
                vec![$(ViewKind::$view.with_defaults(),)*]
            }

            /// Name in files and on the command line.
            pub fn key(&self) -> &'static str {
                let kind = match self {
                    $(Self::$view(_) => ViewKind::$view,)*
                };
                $crate::keys::key_at::<ViewKind>(kind as usize)
            }

            /// Settings as a panel that draws itself.
            pub fn panel(&self) -> &dyn $crate::figure::panel::PanelView {
                match self {
                    $(Self::$view(spec) => spec,)*
                }
            }

            /// Settings as a panel, to be changed.
            pub fn panel_mut(&mut self) -> &mut dyn $crate::figure::panel::PanelView {
                match self {
                    $(Self::$view(spec) => spec,)*
                }
            }
        }

        impl serde::Serialize for ViewSpec {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                // The method that serde derives, not this one.
                Self::serialize(self, serializer)
            }
        }

        impl<'de> serde::Deserialize<'de> for ViewSpec {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Visitor;

                impl<'de> serde::de::Visitor<'de> for Visitor {
                    type Value = ViewSpec;

                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        f.write_str("a view: its name, or an object of its name and its settings")
                    }

                    fn visit_str<E: serde::de::Error>(self, name: &str) -> Result<ViewSpec, E> {
                        use serde::de::IntoDeserializer;
                        let name: serde::de::value::StrDeserializer<'_, E> = name.into_deserializer();
                        <ViewKind as serde::Deserialize>::deserialize(name).map(ViewKind::with_defaults)
                    }

                    fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<ViewSpec, A::Error> {
                        ViewSpec::deserialize(serde::de::value::MapAccessDeserializer::new(map))
                    }
                }

                deserializer.deserialize_any(Visitor)
            }
        }
    };
}

pub(super) use view_list;
