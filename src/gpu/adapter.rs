//! Selection of the graphics adapter: hardware with a modern interface, else GL, else software; the first that works.

use crate::quote::quoted;
use wgpu::{Adapter, AdapterInfo, Backend, DeviceDescriptor, DeviceType, Surface};

/// Environment variable that names the adapter to use (part of its name, any case).
pub const ADAPTER_NAME: &str = "WGPU_ADAPTER_NAME";

/// Environment variable that names the interfaces to use, with commas between.
const BACKENDS: &str = "WGPU_BACKEND";

/// Checks the words in the environment, before a missing driver is thought of.
///
/// # Errors
/// Names the word that is not known, and those that are.
pub fn check_environment() -> Result<(), String> {
    let asked = std::env::var_os(BACKENDS);
    asked.map_or(Ok(()), |asked| check_backends(&asked.to_string_lossy()))
}

fn check_backends(asked: &str) -> Result<(), String> {
    let is_unknown = |word: &&str| wgpu::Backends::from_comma_list(word).is_empty();
    asked.split(',').find(is_unknown).map_or(Ok(()), |unknown| {
        Err(format!(
            "{BACKENDS} names {}, which is no graphics interface; expected vulkan, gl, metal or dx12, or several with commas between",
            quoted(unknown.trim())
        ))
    })
}

/// Preference of an adapter, the most preferred first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rank {
    /// Vulkan, Metal or DX12 on hardware.
    Modern,
    /// OpenGL on hardware.
    Gl,
    /// Software renderer by Vulkan.
    Software,
    /// Software renderer by OpenGL.
    SoftwareGl,
}

/// Preference of an adapter, by its type, name and interface.
pub fn rank(info: &AdapterInfo) -> Rank {
    let name = info.name.to_lowercase();
    let software = info.device_type == DeviceType::Cpu
        || ["llvmpipe", "softpipe", "swiftshader", "software"]
            .iter()
            .any(|word| name.contains(word));
    match (software, info.backend) {
        (false, Backend::Gl) => Rank::Gl,
        (false, _) => Rank::Modern,
        (true, Backend::Gl) => Rank::SoftwareGl,
        (true, _) => Rank::Software,
    }
}

/// The first adapter, in the order of [`rank`], that supports the surface and gives a device.
///
/// # Errors
/// Names the adapters that were tried and why each failed.
pub fn select(adapters: &[Adapter], surface: Option<&Surface<'_>>) -> Result<Adapter, String> {
    let wanted = std::env::var(ADAPTER_NAME)
        .unwrap_or_default()
        .to_lowercase();
    let mut candidates: Vec<&Adapter> = adapters
        .iter()
        .filter(|adapter| adapter.get_info().name.to_lowercase().contains(&wanted))
        .collect();
    candidates.sort_by_key(|adapter| rank(&adapter.get_info()));
    let mut tried = Vec::new();
    for adapter in candidates {
        let failure = if surface.is_some_and(|surface| !adapter.is_surface_supported(surface)) {
            "cannot show on this display".to_string()
        } else {
            match pollster::block_on(adapter.request_device(&device_descriptor(adapter))) {
                Ok(_) => return Ok(adapter.clone()),
                Err(error) => error.to_string(),
            }
        };
        tried.push(format!("{}: {failure}", describe(&adapter.get_info())));
    }
    Err(match tried.as_slice() {
        [] => "no graphics adapter was found".to_string(),
        tried => format!("no graphics adapter works: {}", tried.join("; ")),
    })
}

/// Limits and features that are requested of a device: no more than the adapter has, close to the downlevel defaults.
pub fn device_descriptor(adapter: &Adapter) -> DeviceDescriptor<'static> {
    let base = if adapter.get_info().backend == Backend::Gl {
        wgpu::Limits::downlevel_webgl2_defaults()
    } else {
        wgpu::Limits::downlevel_defaults()
    };
    let limits = adapter.limits();
    DeviceDescriptor {
        label: Some("grazing"),
        required_limits: wgpu::Limits {
            // The window may be larger than the 2048 pixels of the base limits: several screens side by side.
            max_texture_dimension_2d: limits.max_texture_dimension_2d,
            ..base.using_alignment(limits)
        },
        ..Default::default()
    }
}

/// Description of an adapter: name, interface, driver.
pub fn describe(info: &AdapterInfo) -> String {
    let kind = match rank(info) {
        Rank::Modern | Rank::Gl => "",
        Rank::Software | Rank::SoftwareGl => ", software",
    };
    let driver = match (info.driver.as_str(), info.driver_info.as_str()) {
        ("", "") => String::new(),
        (driver, version) => format!(", {}", format!("{driver} {version}").trim()),
    };
    format!("{} ({:?}{kind}{driver})", info.name, info.backend)
}

/// Adapter in four lines: name, driver, interface, type.
pub fn report(info: &AdapterInfo) -> String {
    let driver = format!("{} {}", info.driver, info.driver_info);
    let driver = match driver.trim() {
        "" => "not told",
        driver => driver,
    };
    let kind = match (rank(info), info.device_type) {
        (Rank::Software | Rank::SoftwareGl, _) => "software",
        (_, DeviceType::DiscreteGpu) => "discrete GPU",
        (_, DeviceType::IntegratedGpu) => "integrated GPU",
        (_, DeviceType::VirtualGpu) => "virtual GPU",
        (_, DeviceType::Cpu | DeviceType::Other) => "not told",
    };
    let (name, backend) = (&info.name, info.backend);
    format!("adapter  {name}\ndriver   {driver}\nbackend  {backend:?}\ntype     {kind}")
}

/// wgpu device without a window.
#[derive(Debug)]
pub struct Gpu {
    /// Description of the adapter.
    pub info: AdapterInfo,
    /// Logical device.
    pub device: wgpu::Device,
    /// Command queue of the device.
    pub queue: wgpu::Queue,
}

/// Opens a device without a window, by the preference of [`rank`].
///
/// # Errors
/// Errors of [`select`].
pub fn headless() -> Result<Gpu, String> {
    headless_on(wgpu::Backends::all())
}

/// Opens a device without a window on adapters of these interfaces only.
///
/// # Errors
/// Errors of [`select`].
pub fn headless_on(backends: wgpu::Backends) -> Result<Gpu, String> {
    let instance =
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapters = pollster::block_on(instance.enumerate_adapters(backends));
    let adapter = select(&adapters, None)?;
    let (device, queue) = pollster::block_on(adapter.request_device(&device_descriptor(&adapter)))
        .map_err(|error| error.to_string())?;
    Ok(Gpu {
        info: adapter.get_info(),
        device,
        queue,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn info(name: &str, device_type: DeviceType, backend: Backend) -> AdapterInfo {
        AdapterInfo {
            name: name.into(),
            ..AdapterInfo::new(device_type, backend)
        }
    }

    #[test]
    fn hardware_comes_before_software_and_vulkan_before_gl() {
        let mut list = [
            info("llvmpipe (LLVM 15)", DeviceType::Other, Backend::Gl),
            info("llvmpipe (LLVM 15)", DeviceType::Cpu, Backend::Vulkan),
            info("NVIDIA H200", DeviceType::Other, Backend::Gl),
            info("NVIDIA H200", DeviceType::DiscreteGpu, Backend::Vulkan),
        ];
        list.sort_by_key(rank);
        let order: Vec<_> = list.iter().map(rank).collect();
        assert_eq!(
            order,
            [Rank::Modern, Rank::Gl, Rank::Software, Rank::SoftwareGl]
        );
    }

    #[test]
    fn interfaces_are_those_of_wgpu_and_others_are_named() {
        for asked in ["vulkan", "GL", "vk, gl", "metal,dx12"] {
            assert_eq!(check_backends(asked), Ok(()));
        }
        for (asked, unknown) in [("foo", "\"foo\""), ("gl,bar", "\"bar\""), ("", "\"\"")] {
            let said = check_backends(asked).expect_err("is unknown");
            assert!(
                said.contains(unknown) && said.contains("vulkan, gl"),
                "{said}"
            );
        }
    }

    #[test]
    fn software_is_named_as_such() {
        let text = describe(&info("llvmpipe", DeviceType::Cpu, Backend::Vulkan));
        assert!(
            text.contains("llvmpipe") && text.contains("software"),
            "{text}"
        );
    }

    #[test]
    fn a_report_leaves_no_line_empty() {
        let software = report(&info("llvmpipe", DeviceType::Cpu, Backend::Vulkan));
        let expected = "adapter  llvmpipe\ndriver   not told\nbackend  Vulkan\ntype     software";
        assert_eq!(software, expected);
        let hardware = report(&AdapterInfo {
            driver: "NVIDIA".into(),
            driver_info: "570.1".into(),
            ..info("NVIDIA H200", DeviceType::DiscreteGpu, Backend::Vulkan)
        });
        assert!(hardware.contains("\ndriver   NVIDIA 570.1\n"), "{hardware}");
        assert!(hardware.ends_with("\ntype     discrete GPU"), "{hardware}");
    }
}
