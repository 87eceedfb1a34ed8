#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/program.hpp"

/// Calls of the program that a test goes on beside.
namespace mpmvv::cli {

/// Starts the program with its output and its messages in files of the folder.
inline pid_t start_in(const Folder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "mpmvv");
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child != 0) return child;
  signal(SIGINT, SIG_DFL);  // a shell without job control has what it starts in the background ignore it
  signal(SIGHUP, SIG_DFL);  // as does nohup
  freopen((folder / "out").c_str(), "w", stdout);
  freopen((folder / "messages").c_str(), "w", stderr);
  execv(program().c_str(), words.data());
  _exit(127);
}

/// The exit code of a program that was started as a shell has it, also of one that a signal ended.
inline int exit_code_of(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

template <class Condition>
void wait_for(const Condition& condition) {
  for (int k = 0; k < 3000 && !condition(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

}  // namespace mpmvv::cli
