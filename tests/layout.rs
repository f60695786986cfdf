//! The structs that the CPU uploads against the structs that the shader declares.

use grazing::brdf::wgsl::UNIFORM_SLOTS;
use grazing::gpu::shader;
use grazing::gpu::sphere_pass::SphereUniform;
use naga::{Module, TypeInner};

fn parse(text: &str) -> Module {
    naga::front::wgsl::parse_str(text).expect("the shader parses")
}

/// Size of a struct in bytes, and the offset of each member.
fn layout(module: &Module, name: &str) -> (usize, Vec<(String, usize)>) {
    let (_, ty) = module
        .types
        .iter()
        .find(|(_, ty)| ty.name.as_deref() == Some(name))
        .expect("a struct of this name");
    let TypeInner::Struct { members, span } = &ty.inner else {
        panic!("{name} is no struct")
    };
    let offsets = members
        .iter()
        .map(|m| (m.name.clone().unwrap_or_default(), m.offset as usize))
        .collect();
    (*span as usize, offsets)
}

#[test]
fn the_brdf_uniform_has_a_slot_per_row() {
    let module = parse(&shader::library());
    let (size, members) = layout(&module, "Brdf");
    assert_eq!(size, 16 * UNIFORM_SLOTS);
    assert_eq!(members[1], ("model".to_string(), 16 * (UNIFORM_SLOTS - 1)));
    assert_eq!(
        members[2],
        ("fresnel".to_string(), 16 * (UNIFORM_SLOTS - 1) + 4)
    );
    let (_, params) = layout(&module, "Params");
    for (slot, ((name, offset), row)) in params.iter().zip(&grazing::brdf::params::ALL).enumerate()
    {
        assert_eq!((name.as_str(), *offset), (row.key, 16 * slot));
    }
}

#[test]
fn the_sphere_uniform_has_the_shaders_layout() {
    let (size, members) = layout(&parse(&shader::sphere()), "Sphere");
    assert_eq!(size, size_of::<SphereUniform>());
    let expected = SphereUniform::offsets();
    assert_eq!(members.len(), expected.len());
    for ((name, offset), (wanted_name, wanted)) in members.iter().zip(expected) {
        assert_eq!((name.as_str(), *offset), (wanted_name, wanted));
    }
}

#[test]
fn a_moved_member_is_caught() {
    let moved = shader::sphere().replace(
        "    light_count: u32,",
        "    extra: vec4f,\n    light_count: u32,",
    );
    let (size, _) = layout(&parse(&moved), "Sphere");
    assert_ne!(size, size_of::<SphereUniform>());
}
