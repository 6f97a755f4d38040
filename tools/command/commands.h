// SPDX-License-Identifier: Apache-2.0
// The subcommands of the welkin command line. Each function adds one to the app; parsing runs it. They throw Error.
#pragma once

namespace CLI {
class App;
}

namespace welkin::command {

void addInit(CLI::App& app);
void addBake(CLI::App& app);
void addMerge(CLI::App& app);
void addPlan(CLI::App& app);
void addProject(CLI::App& app);
void addInspect(CLI::App& app);
void addValidate(CLI::App& app);
void addEval(CLI::App& app);
void addSample(CLI::App& app);
void addExport(CLI::App& app);
void addGloss(CLI::App& app);
void addReference(CLI::App& app);
void addStudy(CLI::App& app);
void addRender(CLI::App& app);
void addView(CLI::App& app);
void addCalibrate(CLI::App& app);
void addContact(CLI::App& app);

}  // namespace welkin::command
