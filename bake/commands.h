#pragma once

namespace CLI {
class App;
}

namespace scree::tool {

/// Each adds a subcommand to the program.
void add_bake(CLI::App& app);
void add_info(CLI::App& app);
void add_preview(CLI::App& app);
void add_sample(CLI::App& app);
void add_chart(CLI::App& app);
void add_table(CLI::App& app);
void add_validate(CLI::App& app);

} // namespace scree::tool
