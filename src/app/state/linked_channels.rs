//! Colour parameters whose channels move as one.

use crate::brdf::ParamId;

/// Whether the red, green and blue slider of each colour parameter move as one: "grey" on screen and in session files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LinkedChannels {
    /// Whether those of the diffuse reflectance ρ_d do.
    pub rho_d: bool,
    /// Whether those of the specular amplitude k_s do.
    pub k_s: bool,
}

impl LinkedChannels {
    /// Whether the channels of a parameter move as one; `None` for a parameter that is no colour.
    pub fn get(self, id: ParamId) -> Option<bool> {
        match id {
            ParamId::RhoD => Some(self.rho_d),
            ParamId::KS => Some(self.k_s),
            ParamId::S | ParamId::Alpha | ParamId::Eta => None,
        }
    }

    /// Links or unlinks the channels of a parameter; nothing for a parameter that is no colour.
    pub fn set(&mut self, id: ParamId, linked: bool) {
        match id {
            ParamId::RhoD => self.rho_d = linked,
            ParamId::KS => self.k_s = linked,
            ParamId::S | ParamId::Alpha | ParamId::Eta => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::params::ALL;

    #[test]
    fn colours_have_channels_to_link_and_each_is_set_by_its_name() {
        for row in &ALL {
            let mut linked = LinkedChannels::default();
            linked.set(row.id, true);
            assert_eq!(linked.get(row.id), row.id.is_color().then_some(true));
            for other in ALL.iter().filter(|other| other.id != row.id) {
                assert_ne!(linked.get(other.id), Some(true), "{}", other.key);
            }
        }
    }
}
