// The icons of the interface: characters of the embedded icon font, by what they stand for here.
// The names on the right are those of Material Design Icons 1.6.50.
#pragma once

#include <array>

namespace netwright::icon {

/// The font's file among the assets, and the characters it holds, as a zero-terminated pair for a font atlas.
inline constexpr const char* kFontAsset = "assets/fonts/MaterialDesignIcons.ttf";
inline constexpr std::array<unsigned short, 3> kFontRange{0xF000, 0xF8FF, 0};

inline constexpr const char* kOpen = "\uf256";           // folder-outline
inline constexpr const char* kFile = "\uf224";           // file-outline
inline constexpr const char* kSave = "\uf193";           // content-save
inline constexpr const char* kImport = "\uf2fa";         // import
inline constexpr const char* kExport = "\uf207";         // export
inline constexpr const char* kExportPdf = "\uf225";      // file-pdf
inline constexpr const char* kExportImage = "\uf21f";    // file-image
inline constexpr const char* kExportDrawing = "\uf560";  // vector-polygon
inline constexpr const char* kPrint = "\uf42a";          // printer
inline constexpr const char* kFolder = "\uf24b";         // folder
inline constexpr const char* kFolderUp = "\uf259";       // folder-upload
inline constexpr const char* kHome = "\uf2dc";           // home
inline constexpr const char* kRecent = "\uf150";         // clock
inline constexpr const char* kRefresh = "\uf450";        // refresh
inline constexpr const char* kPlay = "\uf40a";           // play
inline constexpr const char* kPause = "\uf3e4";          // pause
inline constexpr const char* kStop = "\uf4db";           // stop
inline constexpr const char* kStep = "\uf4d7";           // step-forward
inline constexpr const char* kStepBack = "\uf4d5";       // step-backward
inline constexpr const char* kSkip = "\uf4ac";           // skip-forward
inline constexpr const char* kReplay = "\uf45f";         // rewind
inline constexpr const char* kSpeed = "\uf4c5";          // speedometer
inline constexpr const char* kSeed = "\uf1ce";           // dice-5
inline constexpr const char* kShuffle = "\uf49f";        // shuffle-variant
inline constexpr const char* kUndo = "\uf54d";           // undo-variant
inline constexpr const char* kRedo = "\uf44f";           // redo-variant
inline constexpr const char* kDelete = "\uf1c0";         // delete
inline constexpr const char* kFrame = "\uf2f2";          // image-filter-center-focus-weak
inline constexpr const char* kFullscreen = "\uf293";     // fullscreen
inline constexpr const char* kZoomIn = "\uf34b";         // magnify-plus
inline constexpr const char* kZoomOut = "\uf34a";        // magnify-minus
inline constexpr const char* kSearch = "\uf349";         // magnify
inline constexpr const char* kRotate = "\uf464";         // rotate-3d
inline constexpr const char* kPin = "\uf403";            // pin
inline constexpr const char* kUnpin = "\uf404";          // pin-off
inline constexpr const char* kRoot = "\uf4fe";           // target
inline constexpr const char* kTree = "\uf62c";           // source-branch
inline constexpr const char* kModel = "\uf1a7";          // cube-outline
inline constexpr const char* kNet = "\uf1a9";            // cube-unfolded
inline constexpr const char* kFaces = "\uf563";          // vector-triangle
inline constexpr const char* kOverlaps = "\uf55d";       // vector-intersection
inline constexpr const char* kEdges = "\uf55e";          // vector-line
inline constexpr const char* kCut = "\uf190";            // content-cut
inline constexpr const char* kGlue = "\uf3e2";           // paperclip
inline constexpr const char* kPages = "\uf222";          // file-multiple
inline constexpr const char* kRuler = "\uf46d";          // ruler
inline constexpr const char* kTexture = "\uf50c";        // texture
inline constexpr const char* kChart = "\uf12a";          // chart-line
inline constexpr const char* kLayers = "\uf328";         // layers
inline constexpr const char* kNumbers = "\uf423";        // pound
inline constexpr const char* kGrid = "\uf2c1";           // grid
inline constexpr const char* kVisible = "\uf208";        // eye
inline constexpr const char* kHidden = "\uf209";         // eye-off
inline constexpr const char* kSelect = "\uf1b5";         // cursor-default-outline
inline constexpr const char* kPan = "\uf1b6";            // cursor-move
inline constexpr const char* kLocked = "\uf33e";         // lock
inline constexpr const char* kUnlocked = "\uf340";       // lock-open-outline
inline constexpr const char* kSettings = "\uf493";       // settings
inline constexpr const char* kTune = "\uf62e";           // tune
inline constexpr const char* kTheme = "\uf50e";          // theme-light-dark
inline constexpr const char* kLight = "\uf599";          // weather-sunny
inline constexpr const char* kDark = "\uf594";           // weather-night
inline constexpr const char* kKeyboard = "\uf30c";       // keyboard
inline constexpr const char* kHelp = "\uf2d7";           // help-circle
inline constexpr const char* kInfo = "\uf2fd";           // information-outline
inline constexpr const char* kWarning = "\uf026";        // alert
inline constexpr const char* kError = "\uf5d6";          // alert-circle-outline
inline constexpr const char* kDone = "\uf12c";           // check
inline constexpr const char* kProved = "\uf5e0";         // check-circle
inline constexpr const char* kClose = "\uf156";          // close
inline constexpr const char* kAdd = "\uf415";            // plus
inline constexpr const char* kRemove = "\uf374";         // minus
inline constexpr const char* kMenu = "\uf35c";           // menu
inline constexpr const char* kMore = "\uf1d9";           // dots-vertical
inline constexpr const char* kChevronUp = "\uf143";      // chevron-up
inline constexpr const char* kChevronDown = "\uf140";    // chevron-down
inline constexpr const char* kChevronLeft = "\uf141";    // chevron-left
inline constexpr const char* kChevronRight = "\uf142";   // chevron-right
inline constexpr const char* kTime = "\uf51b";           // timer
inline constexpr const char* kWorking = "\uf51f";        // timer-sand
inline constexpr const char* kRestart = "\uf06a";        // autorenew
inline constexpr const char* kFlag = "\uf23c";           // flag-checkered
inline constexpr const char* kFire = "\uf238";           // fire
inline constexpr const char* kHint = "\uf336";           // lightbulb-outline

}  // namespace netwright::icon
