#pragma once
/// What a run can go on from, and with which case.
#include "config/case.hpp"
#include "output/checkpoint.hpp"

namespace starling {

/// The latest checkpoint of a run directory. Throws InputError where there is none or where it is
/// damaged; the message then names the latest one that is whole.
CheckpointFile latest_checkpoint(const std::filesystem::path& run_directory);

/// Which changes of the case are accepted.
enum class Changes {
    stop_and_output, ///< only of title, [stop], [output] and [checkpoint]
    any              ///< all; those of grid and wall still fail when the state is read
};

/// The case that a checkpoint holds.
Case case_of(const CheckpointFile& checkpoint);

/// One line per key in which the cases differ more than a run may on resuming; empty where none
/// does.
std::string differences(const Case& before, const Case& now);

/// The case of the run directory (its case.toml, else the one in the checkpoint) with overrides.
/// Throws InputError that lists the keys where it differs from the checkpoint's more than allowed.
Case resumed_case(const std::filesystem::path& run_directory, const CheckpointFile& checkpoint,
                  const std::vector<std::string>& overrides, Changes allowed);

} // namespace starling
