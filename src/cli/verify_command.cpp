#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/parse_values.h"
#include "cli/progress_bar.h"
#include "cli/render_options.h"
#include "cli/sample_command.h"
#include "cli/scene_setup.h"
#include "error.h"
#include "render/pipeline_file.h"
#include "render/trace_pipeline.h"
#include "render/traversal_form.h"
#include "verify/mutations.h"
#include "verify/verify_report.h"

namespace vernier {
namespace {

struct VerifyArguments {
  std::string rays = "65536";
  std::string level = "robust";
  std::string case_name;
  std::string seed = "0";
  std::string sample;
  std::string mutation;
  std::string json_file;
  std::string device;
  std::string traversal = "auto";
  bool with_costs = true;
  bool quiet = false;
};

CaseSetup case_setup(const VerifyArguments& arguments) {
  CaseSetup setup;
  setup.level = parse_accuracy("--level", arguments.level);
  setup.levels = levels_of(setup.level);
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  setup.seed = parse_count("--seed", arguments.seed, 0, kMost);
  setup.traversal = parse_traversal(arguments.traversal);
  setup.sample_count = parse_count("--rays", arguments.rays, 1, kMost);
  if (!arguments.sample.empty()) {
    if (arguments.case_name.empty()) throw Error(ErrorKind::usage, "--sample: say which --case it is of");
    // A sample is a function of seed, case and number: it comes again as the last of that many.
    setup.sample_count = parse_count("--sample", arguments.sample, 0, kMost - 1) + 1;
  }
  return setup;
}

/// The cases that --case asks for, or all.
std::vector<const VerifyCase*> chosen_cases(const std::string& name) {
  std::vector<const VerifyCase*> chosen;
  if (!name.empty()) {
    chosen.push_back(find_case(name));
    if (chosen.front() == nullptr) {
      throw Error(ErrorKind::usage, "--case: there is no `" + name + "`; the cases are " + case_names());
    }
    return chosen;
  }
  for (const VerifyCase& one : verify_cases()) chosen.push_back(&one);
  return chosen;
}

/// The faults that --mutate asks for.
std::vector<Mutation> chosen_mutations(const std::string& name) {
  if (name.empty()) return {};
  if (name == "all") return {mutations().begin(), mutations().end()};
  const Mutation* found = find_mutation(name);
  if (found == nullptr) {
    throw Error(ErrorKind::usage, "--mutate: there is no `" + name + "`; the faults are all, " + mutation_names());
  }
  return {*found};
}

/// Tells of one piece of the work after the other: lines on standard output, the share that is done on stderr.
class Narrator {
 public:
  Narrator(const VerifyArguments& arguments, std::size_t count)
      : json_file_(arguments.json_file), count_(static_cast<double>(count)), bar_(arguments.quiet) {}

  /// Before the next piece.
  void begin() { bar_.update(clock_.at(begun_++ / count_)); }

  void say(const std::string& text) {
    bar_.clear();
    print_result(json_file_, text);
  }

 private:
  std::string json_file_;
  double count_;
  int begun_ = 0;
  WorkClock clock_;
  ProgressBar bar_;
};

/// Runs `cases` one after the other and tells of each. True when all held.
bool run_suite(const VerifyArguments& arguments, const CaseSetup& setup, const DeviceReport& device,
               const std::vector<const VerifyCase*>& cases) {
  std::string again = arguments.level == "robust" ? "" : " --level " + arguments.level;
  if (arguments.traversal != "auto") again += " --traversal " + arguments.traversal;
  if (!arguments.device.empty()) again += " --device " + shell_word(arguments.device);
  bool held = true;
  std::vector<CaseReport> reports;
  Narrator narrator(arguments, cases.size());
  narrator.say(case_table_head());
  for (const VerifyCase* one : cases) {
    if (interrupted()) break;
    narrator.begin();
    CaseReport report = run_case(*one, setup);
    if (interrupted() && report.result.samples == 0) break;
    reports.push_back(std::move(report));
    narrator.say(case_line(reports.back()));
    if (!reports.back().held) narrator.say(failure_text(reports.back(), setup, again));
    held = held && reports.back().held;
  }
  narrator.say(leak_line(count_leaks(reports)));
  std::vector<LevelCost> costs;
  if (arguments.case_name.empty() && arguments.with_costs && !interrupted()) {
    const SceneSetup builtin = set_up_scene({}, 16.0 / 9.0);
    costs = measure_level_costs(*setup.device, builtin.scene, builtin.camera, {});
    narrator.say(level_cost_table(costs));
  }
  write_json(arguments.json_file, json_text(verify_json(device, setup, reports, costs)));
  return held;
}

/// Seeds the faults one after the other and tells who notices. True when all were caught.
bool run_mutations(const VerifyArguments& arguments, const CaseSetup& setup, const DeviceReport& device,
                   std::span<const Mutation> faults) {
  bool caught = true;
  std::vector<std::vector<CaseReport>> reports;
  Narrator narrator(arguments, faults.size());
  for (const Mutation& fault : faults) {
    if (interrupted()) break;
    narrator.begin();
    std::vector<CaseReport> seeded = run_mutation(fault, setup);
    if (interrupted()) break;  // cases that were cut short say nothing
    reports.push_back(std::move(seeded));
    narrator.say(mutation_line(fault, reports.back()));
    caught = caught && is_caught(reports.back());
  }
  write_json(arguments.json_file, json_text(mutations_json(device, setup, faults.first(reports.size()), reports)));
  return caught;
}

int run_verify(const VerifyArguments& arguments) {
  CaseSetup setup = case_setup(arguments);
  const std::vector<const VerifyCase*> cases = chosen_cases(arguments.case_name);
  const std::vector<Mutation> faults = chosen_mutations(arguments.mutation);
  if (!faults.empty() && !arguments.case_name.empty()) {
    throw Error(ErrorKind::usage, "--mutate: not with --case; each fault has its own cases");
  }
  check_json_output(arguments.json_file);
  const VulkanInstance instance;
  const DeviceDescription description = choose_device(list_devices(instance), arguments.device);
  const CachedDevice device(instance, description, pipeline_file(description.pipeline_key));
  setup.device = &device.device();
  catch_interrupt();
  setup.stop = interrupted;
  require_loads(description, choose_scene_loads(description, setup.traversal));
  const DeviceReport report{description, probe_device(device.device()), ""};
  print_result(arguments.json_file, describe_devices({&report, 1}) + "\n");
  const bool good =
      faults.empty() ? run_suite(arguments, setup, report, cases) : run_mutations(arguments, setup, report, faults);
  device.store();
  if (interrupted()) throw Error(ErrorKind::failed, "interrupted; what was done by then is told");
  return good ? 0 : static_cast<int>(ErrorKind::failed);
}

}  // namespace

void add_verify_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<VerifyArguments>();
  CLI::App& command = *app.add_subcommand(
      "verify",
      "Runs the hard cases of the numeric suite on a device, with the shader functions that render. Exit code 0 "
      "when every target of the level is met, or when every seeded fault was caught; else 1.");
  command
      .add_option("--rays", arguments->rays,
                  "samples per case; fewer where one is a picture or a long sum (default: 65536)")
      ->type_name("N");
  command
      .add_option("--level,--accuracy", arguments->level,
                  "numeric level: fast (shown, no targets), robust or exact (default: robust)")
      ->type_name("fast|robust|exact");
  command.add_option("--case", arguments->case_name, "one case by its name (default: all)")->type_name("NAME");
  command.add_option("--seed", arguments->seed, "of the inputs (default: 0)")->type_name("N");
  command.add_option("--sample", arguments->sample, "runs --case up to this sample number (default: all of --rays)")
      ->type_name("N");
  command
      .add_option("--mutate", arguments->mutation,
                  "seeds a known fault and shows which case catches it: a name or all (default: none)")
      ->type_name("NAME|all");
  command.add_option("--json", arguments->json_file, "writes the same as JSON (default: none)")->type_name("FILE");
  command.add_flag("--costs,!--no-costs", arguments->with_costs,
                   "times a picture at each level of each spot, when all cases run (default: on)");
  add_device_option(command, arguments->device);
  add_traversal_option(command, arguments->traversal);
  command.add_flag("--quiet", arguments->quiet, "no progress (default: off)");
  command.footer("Example: vernier verify --case shared_edge --rays 1000000");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_verify(*arguments); }; });
}

}  // namespace vernier
