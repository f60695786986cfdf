//! Settings of a view, with and without their type.

use crate::app::state::view_id::ViewId;
use crate::keys;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::any::Any;
use std::fmt;

/// Settings of one view: what its figure shows, and what only the window has.
pub trait Settings:
    Clone + PartialEq + fmt::Debug + Default + Serialize + DeserializeOwned + Send + Sync + 'static
{
    /// The view that has these settings.
    const VIEW: ViewId;

    /// The nearest settings that can be shown: every number in its range, every position inside its list.
    fn sanitized(self) -> Self;
}

/// Kind of settings: how those of one type are made and read, without the type.
#[derive(Clone, Copy)]
pub struct SettingsKind {
    default: fn() -> AnySettings,
    read: fn(&Value) -> Result<AnySettings, serde_json::Error>,
}

impl SettingsKind {
    /// The kind of a type of settings.
    pub const fn of<T: Settings>() -> Self {
        Self {
            default: || AnySettings::new(T::default()),
            read: |value| {
                let known = serde_json::to_value(T::default())?;
                let mut kept = with_known_keys(value, &known);
                // Keys that are not written where they are as at first.
                for key in keys::names::<T>() {
                    if let (Some(to), None, Some(from)) =
                        (kept.as_object_mut(), known.get(key), value.get(key))
                    {
                        to.insert((*key).to_owned(), from.clone());
                    }
                }
                T::deserialize(kept).map(AnySettings::new)
            },
        }
    }

    /// The settings that a view has at first.
    pub fn initial(&self) -> AnySettings {
        (self.default)()
    }

    /// Settings from a session; they may be out of range ([`AnySettings::sanitized`]).
    ///
    /// # Errors
    /// What is not understood.
    pub fn read(&self, value: &Value) -> Result<AnySettings, serde_json::Error> {
        (self.read)(value)
    }
}

/// A value without the keys that `known` lacks: a session names them and opens without them, though a figure's spec
/// refuses them.
fn with_known_keys(value: &Value, known: &Value) -> Value {
    match (value, known) {
        (Value::Object(value), Value::Object(known)) => {
            let kept = value.iter().filter_map(|(key, value)| {
                Some((key.clone(), with_known_keys(value, known.get(key)?)))
            });
            Value::Object(kept.collect())
        }
        // The members of a list are all of a kind.
        (Value::Array(value), Value::Array(known)) => match known.first() {
            Some(known) => value
                .iter()
                .map(|one| with_known_keys(one, known))
                .collect(),
            None => Value::Array(value.clone()),
        },
        _ => value.clone(),
    }
}

impl fmt::Debug for SettingsKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("SettingsKind")
    }
}

/// Settings of some view.
pub struct AnySettings(Box<dyn ErasedSettings>);

/// [`Settings`] without the type.
trait ErasedSettings: Send + Sync {
    fn view(&self) -> ViewId;
    fn as_any(&self) -> &dyn Any;
    fn as_any_mut(&mut self) -> &mut dyn Any;
    fn clone_settings(&self) -> AnySettings;
    fn sanitized(&self) -> AnySettings;
    fn equals(&self, other: &dyn Any) -> bool;
    fn to_json(&self) -> Result<Value, serde_json::Error>;
    fn debug(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;
}

impl<T: Settings> ErasedSettings for T {
    fn view(&self) -> ViewId {
        T::VIEW
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }

    fn clone_settings(&self) -> AnySettings {
        AnySettings::new(self.clone())
    }

    fn sanitized(&self) -> AnySettings {
        AnySettings::new(Settings::sanitized(self.clone()))
    }

    fn equals(&self, other: &dyn Any) -> bool {
        other.downcast_ref::<T>() == Some(self)
    }

    fn to_json(&self) -> Result<Value, serde_json::Error> {
        serde_json::to_value(self)
    }

    fn debug(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

impl AnySettings {
    /// The settings of a view.
    pub fn new<T: Settings>(settings: T) -> Self {
        Self(Box::new(settings))
    }

    /// The view that has these settings.
    pub fn view(&self) -> ViewId {
        self.0.view()
    }

    /// The settings, if they are of this type.
    pub fn downcast<T: Settings>(&self) -> Option<&T> {
        self.0.as_any().downcast_ref()
    }

    /// The settings to be changed, if they are of this type.
    pub fn downcast_mut<T: Settings>(&mut self) -> Option<&mut T> {
        self.0.as_any_mut().downcast_mut()
    }

    /// See [`Settings::sanitized`].
    pub fn sanitized(&self) -> Self {
        self.0.sanitized()
    }

    /// JSON value, as a session keeps it.
    ///
    /// # Errors
    /// None that can be expected: settings are data that JSON has.
    pub fn to_json(&self) -> Result<Value, serde_json::Error> {
        self.0.to_json()
    }
}

impl Clone for AnySettings {
    fn clone(&self) -> Self {
        self.0.clone_settings()
    }
}

impl PartialEq for AnySettings {
    fn eq(&self, other: &Self) -> bool {
        self.0.equals(other.0.as_any())
    }
}

impl fmt::Debug for AnySettings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.debug(f)
    }
}
