// What the entries of /diagnostics say. OK needs fresh and valid input; numbers stand alone, with
// their unit in the key, so that plotting tools pick them up.
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "footprint_collision_predictor/CollisionWarning.h"
#include "master_watch.hpp"
#include "reconfiguration.hpp"
#include "report.hpp"

namespace footprint_collision_predictor {

using Status = diagnostic_updater::DiagnosticStatusWrapper;

void describe(const CollisionWarning& warning, Status& status);
void describe(const InputReport& input, Status& status);
/// \param obstacles tell whether the transforms are in use
void describe(const TransformReport& transforms, const InputReport& obstacles, Status& status);
void describe(const ComputationReport& computation, double max_data_age, Status& status);
void describe(const ClockReport& clock, Status& status);
void describe(const MasterView& master, Status& status);
void describe(const ConfigurationReport& configuration, Status& status);

}  // namespace footprint_collision_predictor
