#include "morph_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "easing.h"
#include "frames.h"
#include "key_times.h"
#include "names.h"
#include "tandem/io/animated_vector.h"
#include "tandem/io/lottie.h"
#include "tandem/io/picture.h"
#include "tandem/io/svg.h"
#include "usage_error.h"
#include "values.h"

namespace cli {
namespace {

constexpr int kDefaultFrames = 60;
constexpr int kMostFrames = 100'000;
constexpr int kLargestPicture = 8192;
constexpr double kGifFramesPerSecond = 50.0;  // format_gif()
constexpr int kMostDecimals = 15;
constexpr double kFarthest = 1e6;              // beyond the first and the last shape
constexpr double kLongestDuration = 86'400.0;  // a day, in seconds

/// Seconds, as a number or as in CSS: 2, 2s, 500ms.
double parse_duration(const std::string& text) {
  const auto ends_with = [&](std::string_view unit) {
    return text.size() > unit.size() && text.compare(text.size() - unit.size(), unit.size(), unit) == 0;
  };
  if (ends_with("ms")) {
    return 1e-3 * parse_number("--duration", text.substr(0, text.size() - 2), 1.0, 1e3 * kLongestDuration);
  }
  return parse_number("--duration", ends_with("s") ? text.substr(0, text.size() - 1) : text, 1e-3,
                      kLongestDuration);
}

/// --frames and --at: where in-betweens are taken.
void plan_positions(const Command& command, MorphOutput& plan) {
  if (!command.frames.empty()) plan.frames = parse_count("--frames", command.frames, 2, kMostFrames);
  if (command.at.empty()) {
    const int count = plan.frames == 0 ? kDefaultFrames : plan.frames;
    for (int i = 0; i < count; ++i) plan.positions.push_back(static_cast<double>(i) / (count - 1));
    if (plan.format == Format::png) {
      throw UsageError(".png holds one in-between: --at S; for several there is DIRECTORY/ with --to png");
    }
    if (plan.format == Format::csv) {
      throw UsageError(".csv holds one in-between: --at S; for several there is .json or DIRECTORY/");
    }
    return;
  }
  if (!command.frames.empty()) throw UsageError("--frames and --at exclude each other");
  for (const std::string& part : split_list("--at", command.at))
    plan.positions.push_back(parse_number("--at", part, -kFarthest, kFarthest));
  plan.at_given = true;
  const char* const one = plan.format == Format::svg   ? "an .svg"
                          : plan.format == Format::png ? "a .png"
                          : plan.format == Format::csv ? "a .csv"
                                                       : nullptr;
  if (one != nullptr && plan.positions.size() != 1) {
    throw UsageError(
        fmt::format("--at with {} takes one number; for several there is .json or DIRECTORY/", one));
  }
  plan.still = plan.format == Format::svg;
  constexpr std::array kAnimations = {std::pair{Format::html, ".html"}, std::pair{Format::css, ".css"},
                                      std::pair{Format::lottie, ".lottie.json"},
                                      std::pair{Format::animated_vector, ".avd.xml"},
                                      std::pair{Format::gif, ".gif"}};
  for (const auto& [format, ending] : kAnimations) {
    if (plan.format == format) {
      throw UsageError(fmt::format(
          "--at does not go with {}, which holds the way from the first shape to the last", ending));
    }
  }
}

void plan_animation(const Command& command, MorphOutput& plan) {
  tandem::AnimationOptions& animation = plan.animation;
  const std::size_t shapes = std::max<std::size_t>(command.inputs.size(), 2);
  animation.duration = parse_duration(command.duration);
  const KeyTimes times = parse_key_times(command.times, shapes);
  if (times.duration) {
    if (command.app->count("--duration") > 0) {
      throw UsageError("--times in seconds say the duration as well: --duration does not go with them");
    }
    animation.duration = *times.duration;
  }
  plan.key_times = times.shares;
  animation.easing = parse_easings(command.easings, shapes - 1);
  enum class Play { alternate, loop, once };
  const auto play = choose<Play>(
      "--play", command.play, {{"alternate", Play::alternate}, {"loop", Play::loop}, {"once", Play::once}});
  animation.alternate = play == Play::alternate;
  animation.repeat = play != Play::once;
  if (!command.precision.empty()) {
    animation.precision = parse_count("--precision", command.precision, 0, kMostDecimals);
  }
}

}  // namespace

void note_idle_flags(const Command& command, const MorphOutput& plan, const Messages& messages) {
  const auto is = [&](std::initializer_list<Format> formats) {
    return std::find(formats.begin(), formats.end(), plan.format) != formats.end();
  };
  const bool moves = !plan.still && is({Format::svg, Format::html, Format::css, Format::lottie,
                                        Format::animated_vector, Format::gif});
  const std::array<std::pair<const char*, bool>, 7> works = {{
      {"--frames", is({Format::json, Format::directory, Format::gif})},
      {"--duration", moves},
      {"--easing", moves},
      {"--play", moves},
      {"--size", is({Format::gif, Format::png, Format::lottie, Format::css}) || plan.png_frames},
      {"--css", is({Format::css})},
      {"--name", is({Format::css})},
  }};
  for (const auto& [flag, does] : works) {
    if (!does && command.app->count(flag) > 0) {
      messages.note(fmt::format("{} changes nothing in what is written here", flag));
    }
  }
}

void add_morph_output_flags(Command& command) {
  CLI::App& app = *command.app;
  app.add_option("-o,--output", command.output,
                 ".svg (animated), .html (player), .css, .lottie.json, .avd.xml (Android), .gif, .json "
                 "(frames), .png (--at), .csv (motions), DIR/, -")
      ->type_name("OUT");
  app.add_option("--to", command.to,
                 "svg, html, css, lottie, avd, gif, png, csv, json: whatever the ending of OUT")
      ->type_name("FORMAT");
  app.add_option("--frames", command.frames, "Number of frames in .json, DIR/ (60) and .gif (25 a second)")
      ->type_name("N");
  app.add_option("--at", command.at, "These in-betweens instead: 0 is A, 1 the last shape")
      ->type_name("S,...");
  app.add_option("--duration", command.duration, "Time from the first shape to the last: 2, 2s, 500ms (2)")
      ->type_name("X");
  app.add_option("--easing", command.easings,
                 "linear, ease, ease-in, ease-out, ease-in-out, x1,y1,x2,y2; once, or once per step")
      ->type_name("NAME")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  app.add_option("--times", command.times,
                 "When the shapes are reached: 0,0.4,1 or 0%,40%,100% or 0s,0.8s,2s (evenly)")
      ->type_name("T,...");
  app.add_flag("--smooth", command.smooth, "Pass the shapes between the first and the last without a stop");
  app.add_option("--play", command.play, "alternate (there and back), loop, once")->type_name("HOW");
  app.add_option("--size", command.size, "Pixels of the longer side: .gif, .png, .lottie.json (512)")
      ->type_name("N");
  app.add_option("--precision", command.precision, "Decimals of coordinates (as the size needs)")
      ->type_name("N");
  app.add_option("--css", command.css, "What a .css animates: d, clip-path")->type_name("PROPERTY");
  app.add_option("--name", command.name, "Class and @keyframes of a .css (morph)")->type_name("NAME");
}

MorphOutput plan_morph_output(const Command& command) {
  if (command.output.empty()) {
    throw UsageError(
        "morph needs -o OUT: .svg, .html, .css, .lottie.json, .avd.xml, .gif, .json, DIRECTORY/, or - for "
        "JSON "
        "on standard output");
  }
  MorphOutput plan;
  plan.format =
      output_format(command.output, command.to,
                    {Format::svg, Format::html, Format::css, Format::lottie, Format::animated_vector,
                     Format::gif, Format::png, Format::csv, Format::json, Format::directory});
  plan.title = title(command.inputs);
  plan.png_frames = command.to == "png";
  plan.size = parse_count("--size", command.size, 1, kLargestPicture);
  plan.css.size = plan.size;
  plan.css.name = command.name;
  if (!tandem::is_css_name(plan.css.name)) {
    throw UsageError(
        fmt::format("--name takes a letter, then letters, digits, - and _, not '{}'", plan.css.name));
  }
  plan.css.property = choose<tandem::CssProperty>(
      "--css", command.css, {{"d", tandem::CssProperty::d}, {"clip-path", tandem::CssProperty::clip_path}});
  plan_animation(command, plan);
  plan_positions(command, plan);
  if (plan.format == Format::gif && plan.frames - 1 > kGifFramesPerSecond * plan.animation.duration) {
    throw UsageError(fmt::format("--frames {} in {} s: a .gif shows at most {} a second", plan.frames,
                                 plan.animation.duration, kGifFramesPerSecond));
  }
  return plan;
}

void write_morph(const Command& command, const MorphOutput& plan, const tandem::PathMorph& paths,
                 const tandem::Look& look, const std::string& reports) {
  const auto content = [&]() -> std::string {
    switch (plan.format) {
      case Format::svg:
        return plan.still ? format_frame_svg(paths, plan.positions.front(), plan.animation.precision, look)
                          : format_animated_svg(paths, plan.animation, look);
      case Format::html:
        return format_html_player(paths, plan.title, plan.animation, look);
      case Format::css:
        return format_css(paths, plan.animation, plan.css, look);
      case Format::lottie:
        return format_lottie(paths, plan.title, plan.animation, plan.size, look);
      case Format::animated_vector:
        return format_animated_vector(paths, plan.animation, look);
      case Format::gif:
        return format_gif(paths, plan.animation, plan.frames, plan.size, look);
      case Format::png:
        return format_png(paths, plan.positions.front(), plan.size, look);
      default:
        return format_path_frames(paths, plan.positions, reports, plan.animation.precision);
    }
  };
  if (plan.format != Format::directory) return write_output(command.output, content());
  write_frame_directory(command.output, plan.positions.size(), plan.png_frames ? ".png" : ".svg",
                        [&](std::size_t i) {
                          const double s = plan.positions[i];
                          return plan.png_frames ? format_png(paths, s, plan.size, look)
                                                 : format_frame_svg(paths, s, plan.animation.precision, look);
                        });
}

}  // namespace cli
