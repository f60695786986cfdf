//! The structs that the CPU uploads against the structs that the shader declares.

use grazing::gpu::lobe3d_pass::SpaceUniform;
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

/// GL lays a struct out by its members' types alone, so that an @align in the text gives it other numbers than the rest.
fn is_the_same_on_gl(source: &str) -> bool {
    // The builtin comments of WGSL may speak of it; a member that has it starts with it.
    let mut lines = source.lines().map(str::trim_start);
    !lines.any(|line| line.starts_with("@align") || line.starts_with("@size"))
}

#[test]
fn uniforms_are_laid_out_the_same_on_gl() {
    let source = shader::sphere();
    assert!(is_the_same_on_gl(&source));
    let planted = source.replace("    split: f32,", "    @align(16) split: f32,");
    assert!(planted != source && !is_the_same_on_gl(&planted));
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
fn the_space_uniform_has_the_shaders_layout() {
    let source = shader::lobe3d();
    assert!(is_the_same_on_gl(&source));
    let (size, members) = layout(&parse(&source), "Space");
    assert_eq!(size, size_of::<SpaceUniform>());
    for ((name, offset), (wanted_name, wanted)) in members.iter().zip(SpaceUniform::offsets()) {
        assert_eq!((name.as_str(), *offset), (wanted_name, wanted));
    }
    let planted = source.replace("    density: f32,", "    extra: vec4f,\n    density: f32,");
    assert_ne!(layout(&parse(&planted), "Space").0, size);
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
