#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace mpmvv::cli {

/// Studies to be run by a cluster's machines. All paths are absolute.
struct Submission {
  std::filesystem::path program, place, folder, db, costs, goldens;  ///< place: where it was submitted from
  std::vector<std::string> files;                                    ///< of the studies
  std::vector<std::string> gated;                                    ///< names of those that have goldens
  std::size_t shards = 1;
  int jobs = 1;                            ///< cases at once on a machine
  std::size_t minutes = 0, megabytes = 0;  ///< what to ask for, for the shard that needs most
  bool alone = false;                      ///< costs are measured: nothing else on the machine
  std::string partition, account;          ///< empty: the cluster's
  std::vector<std::string> options;        ///< more options of every job, as the engine takes them
};

struct Script {
  std::string name, text;
};

/// What hands work to machines.
struct Engine {
  const char* name;
  const char* command;                                ///< the program that submit.sh calls
  const char* queued;                                 ///< how what is queued is found and taken back
  std::vector<Script> (*scripts)(const Submission&);  ///< submit.sh starts them: all shards, or "2,5-7"
};

std::span<const Engine> engines();

/// Scripts for Slurm: an array of jobs with a shard each, and a job that waits for the array, merges the stores, makes
/// the studies, gates and reports.
std::vector<Script> slurm_scripts(const Submission& submission);

}  // namespace mpmvv::cli
