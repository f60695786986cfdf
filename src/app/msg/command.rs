//! Commands: everything that a person can ask for. [`crate::app::command`] has the words, the keys and the places in menus.

use crate::app::state::prefs::Theme;
use crate::app::state::side_panels::Side;
use crate::app::state::views::ViewId;
use crate::app::views::sphere::settings::Show;
use crate::brdf::fresnel::Fresnel;
use crate::figure::lobes::LobeScale;
use crate::files::ModelFormat;
use crate::fit::Weight;

/// Something a person can ask for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the rows below say what each one does")]
pub enum Command {
    Open,
    OpenPath,
    OpenFolder,
    CloseFolder,
    FitFolder,
    CompareFolder,
    CancelFitFolder,
    SaveFits,
    OpenSample(usize),
    OpenRecent(usize),
    ClearRecent,
    Close,
    ExportModel(ModelFormat),
    ExportFigure,
    SaveSession,
    SaveSessionAs,
    SavePicture,
    Quit,
    Undo,
    Redo,
    Copy,
    CopyPicture,
    CopyNumbers,
    CopyProbe,
    Unpin,
    CopyParams,
    GuessParams,
    ResetParams,
    UseModel(usize),
    UseFresnel(Fresnel),
    Fit,
    Compare,
    CompareFamily,
    CompareEvery,
    ToggleCompared(usize),
    ToggleComparedFresnel(Fresnel),
    CancelFit,
    ToggleKeepOptimal,
    ToggleFromSliders,
    ToggleFitOnOpening,
    UseWeight(Weight),
    NextMaterial,
    PreviousMaterial,
    UseShow(Show),
    UseLights(usize),
    UseScale(LobeScale),
    ToggleCosine,
    ToggleCosineO,
    ToggleShapeOnly,
    ToggleRaw,
    UseTheme(Theme),
    ZoomIn,
    ZoomOut,
    ZoomReset,
    TogglePanel(Side),
    ToggleTile(ViewId),
    ResetLayout,
    Palette,
    Lesson(usize),
    Guide,
    Conventions,
    About,
}
