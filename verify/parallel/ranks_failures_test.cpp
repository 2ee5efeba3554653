// SPDX-License-Identifier: MIT
// What ends a step on one rank ends it on all, with the same error; what they decide, they decide
// alike; and how messages say what has changed.
#include "support/random/scene.h"
#include "support/thread_ranks.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/parallel.h"
#include "dsc/parallel/ranks/list_difference.h"
#include "dsc/parallel/ranks/share_out.h"
#include "dsc/queries/hash.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <string>

namespace dsc::ranks_failures_test {
namespace {

constexpr double h = 0.012;

struct Own {
    explicit Own(Ranks* ranks, Options<double> chosen = {})
        : complex(test::disc_complex<double>(h)), options(std::move(chosen)) {
        options.edge_length = h;
        Parallel parallel;
        parallel.submeshes = 6;
        parallel.ranks = ranks;
        parallel.checks_ranks = true;
        simulation = std::make_unique<Simulation<double>>(complex, options, parallel);
    }
    Complex<double> complex;
    Options<double> options;
    std::unique_ptr<Simulation<double>> simulation;
};

const Velocity<double> growing = [](auto positions, double, auto velocities) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        velocities[i] = (positions[i] - Point<double>(0.5, 0.5)).normalized();
    }
};

std::string text_of(const std::exception_ptr& thrown) {
    if (!thrown) {
        return "nothing was thrown";
    }
    try {
        std::rethrow_exception(thrown);
    } catch (const InputError& error) {
        return std::string("InputError: ") + error.what();
    } catch (const FileError& error) {
        return std::string("FileError: ") + error.path() + " | " + error.what();
    } catch (const InvariantError& error) {
        return std::string("InvariantError: ") + error.what();
    } catch (const std::exception& error) {
        return std::string("other: ") + error.what();
    }
}

// Throws on one rank alone, from some call on.
template <class Error>
Velocity<double> failing(bool fails, const Error& error) {
    return [fails, error, calls = std::make_shared<std::atomic<int>>(0)](
               auto positions, double time, auto velocities) {
        if (fails && ++*calls > 5) {
            throw error;
        }
        growing(positions, time, velocities);
    };
}

template <class Error>
void expect_all_throw(const Error& error, const std::string& text) {
    for (const std::uint32_t size : {2U, 3U}) {
        for (std::uint32_t who = 0; who < size; ++who) {
            std::vector<std::uint64_t> hashes(size);
            const auto thrown = run_ranks(size, [&](Ranks& ranks) {
                Own own(&ranks);
                const auto velocity = failing(ranks.rank() == who, error);
                std::exception_ptr first;
                try {
                    for (int step = 0; step < 5; ++step) {
                        own.simulation->step(velocity, 0.01 * step, 0.01);
                    }
                } catch (...) {
                    first = std::current_exception();
                }
                EXPECT_EQ(text_of(first), text);
                // All hold the same valid complex, and may go on.
                EXPECT_EQ(validate(own.complex).problem, "");
                own.simulation->step(growing, 0.1, 0.01);
                hashes[ranks.rank()] = mesh_hash(own.complex);
                if (first) {
                    std::rethrow_exception(first);
                }
            });
            for (std::uint32_t rank = 0; rank < size; ++rank) {
                EXPECT_EQ(text_of(thrown[rank]), text) << "rank " << rank;
                EXPECT_EQ(hashes[rank], hashes[0]) << "rank " << rank;
            }
        }
    }
}

TEST(RanksFailures, OneThatThrowsInItsSubmeshesStopsAllAndTheyMayGoOn) {
    const InputError input(
        {.what = "no such place", .where = "velocity", .value = "3", .allowed = "1 or 2"});
    expect_all_throw(input, std::string("InputError: ") + input.what());
    const FileError file("cannot be read", "a/b", 2);
    expect_all_throw(file, std::string("FileError: a/b | ") + file.what());
    expect_all_throw(std::runtime_error("a solver failed"), "other: a solver failed");
}

// What is thrown outside the submeshes, on one rank alone: the others learn of it where they wait.
TEST(RanksFailures, OneThatLeavesIsNotWaitedFor) {
    const auto thrown = run_ranks(3, [](Ranks& ranks) {
        Own own(&ranks);
        own.simulation->step(growing, 0, 0.01);
        if (ranks.rank() == 1) {
            throw FileError("cannot be written", "frame.vtu");
        }
        own.simulation->step(growing, 0.01, 0.01);
    });
    for (const auto& one : thrown) {
        EXPECT_EQ(text_of(one), "FileError: frame.vtu | frame.vtu: cannot be written");
    }
}

// The step itself tells the others, so that they do not depend on the application for it.
TEST(RanksFailures, AListenerThatThrowsOnOneRankStopsAll) {
    std::vector<std::string> texts(3);
    (void)run_ranks(3, [&](Ranks& ranks) {
        Own own(&ranks);
        if (ranks.rank() == 2) {
            own.simulation->add_listener(
                [](std::span<const Edit>) { throw std::runtime_error("no more room"); });
        }
        try {
            own.simulation->step(growing, 0, 0.1); // of several sub-steps
        } catch (...) {
            texts[ranks.rank()] = text_of(std::current_exception());
        }
        EXPECT_TRUE(ranks.has_failed());
        ranks.start_over();
    });
    EXPECT_EQ(texts, std::vector<std::string>(3, "other: no more room"));
}

TEST(RanksFailures, OneThatHasEndedIsNotWaitedFor) {
    const auto thrown = run_ranks(2, [](Ranks& ranks) {
        for (std::uint32_t i = 0; i < 2 + ranks.rank(); ++i) {
            ranks.wait_for_all();
        }
    });
    EXPECT_EQ(text_of(thrown[1]), "other: rank 0 has ended before the others");
}

TEST(RanksFailures, ADifferenceBetweenTheRanksIsFound) {
    const auto thrown = run_ranks(2, [](Ranks& ranks) {
        Own own(&ranks);
        own.simulation->step(growing, 0, 0.01);
        if (ranks.rank() == 1) {
            own.complex.vertices[7].flags ^= vertex_locked;
        }
        own.simulation->step(growing, 0.01, 0.01);
    });
    for (const auto& one : thrown) {
        EXPECT_EQ(text_of(one), "InvariantError: ranks 0 and 1 differ before a step in the "
                                "vertices, entry 7 (id 7)");
    }
}

TEST(RanksFailures, AnInterruptionOfOneIsOneOfAll) {
    std::vector<double> reached(3);
    run_all_ranks(3, [&](Ranks& ranks) {
        Own own(&ranks);
        const std::atomic<bool> flag = ranks.rank() == 2;
        own.simulation->interrupt_by(&flag);
        const StepReport report = own.simulation->step(growing, 0, 0.1); // of several sub-steps
        EXPECT_EQ(report.gave_up, GiveUp::interrupted);
        reached[ranks.rank()] = report.reached;
    });
    EXPECT_GT(reached[0], 0);
    EXPECT_LT(reached[0], 0.1);
    EXPECT_EQ(reached[1], reached[0]);
    EXPECT_EQ(reached[2], reached[0]);
}

TEST(RanksFailures, ASignalToOneIsKnownToAllAfterTheSameStep) {
    std::vector<int> steps(3, 0);
    run_all_ranks(3, [&](Ranks& ranks) {
        std::atomic<bool> flag = false;
        ranks.stop_by(&flag);
        Own own(&ranks);
        while (!ranks.is_to_stop() && steps[ranks.rank()] < 20) {
            own.simulation->step(growing, 0.001 * steps[ranks.rank()]++, 0.001);
            flag = flag || (ranks.rank() == 1 && steps[1] == 4);
        }
    });
    EXPECT_EQ(steps, std::vector<int>(3, 5));
}

TEST(RanksFailures, CopiedSubmeshesAreRefused) {
    const auto thrown = run_ranks(2, [](Ranks& ranks) {
        auto complex = test::disc_complex<double>(h);
        Options<double> options;
        options.edge_length = h;
        Parallel parallel;
        parallel.division = Division::copy;
        parallel.ranks = &ranks;
        Simulation<double> simulation(complex, options, parallel);
    });
    EXPECT_EQ(
        text_of(thrown[1]),
        "InputError: Parallel.division: submeshes that are copied cannot be shared by several "
        "processes: got copy; allowed: fixed, counting, active, blocks or cells");
}

// Passes of an application that write to attributes of its own, and say where. What the first one
// writes is blended where edges are split after it, in the same section.
Algorithm<double> counting_visits() {
    Algorithm<double> algorithm = default_algorithm<double>();
    algorithm.motion.insert(algorithm.motion.begin(),
                            {"heats", [](Work<double>& work) {
                                 auto& heats = work.complex.attributes.get<Vertex, double>("heats");
                                 for (const std::uint32_t v : work.interface) {
                                     heats[Vertex{v}] += 1 + v % 7;
                                     work.touch(v);
                                 }
                             }});
    algorithm.upkeep.push_back({"visits", [](Work<double>& work) {
                                    auto& visits =
                                        work.complex.attributes.get<Vertex, int>("visits");
                                    for (const std::uint32_t v : work.interface) {
                                        if (v % 3 == 0) {
                                            ++visits[Vertex{v}];
                                            work.touch(v);
                                        }
                                    }
                                }});
    return algorithm;
}

TEST(RanksFailures, ValuesThatAPassWritesAreTold) {
    std::vector<int> visits(2, 0);
    run_all_ranks(2, [&](Ranks& ranks) {
        auto complex = test::disc_complex<double>(h);
        complex.attributes.add<Vertex, int>("visits", 0);
        complex.attributes.add<Vertex, double>("heats", 0.0);
        Options<double> options;
        options.edge_length = h;
        Parallel parallel;
        parallel.submeshes = 6;
        parallel.ranks = &ranks;
        parallel.checks_ranks = true; // compares the attributes as well
        Simulation<double> simulation(complex, options,
                                      make_executor(complex, options, parallel, counting_visits()));
        std::uint64_t splits = 0;
        for (int step = 0; step < 4; ++step) {
            splits += simulation.step(growing, 0.01 * step, 0.01).operations.splits;
        }
        EXPECT_GT(splits, 0U);
        for (const int one : complex.attributes.get<Vertex, int>("visits").data()) {
            visits[ranks.rank()] += one;
        }
    });
    EXPECT_GT(visits[0], 50);
    EXPECT_EQ(visits[1], visits[0]);
}

TEST(RanksFailures, TheDifferenceOfListsMakesOneOfTheOther) {
    std::mt19937 engine(5);
    const auto random = [&engine] { return static_cast<std::uint32_t>(engine()); };
    for (int round = 0; round < 2000; ++round) {
        std::vector<std::uint32_t> before(random() % 40);
        for (auto& id : before) {
            id = random() % 60;
        }
        std::vector<std::uint32_t> after;
        for (const std::uint32_t id : before) {
            const auto fate = random() % 10;
            if (fate > 1 || round % 2 == 0) {
                after.push_back(id);
            }
            if (fate > 7) {
                after.push_back(random() % 60);
            }
        }
        if (round % 7 == 0) {
            std::ranges::reverse(after);
        }
        MessageWriter message;
        write_difference(message, before, after);
        MessageReader reader(message.bytes());
        std::vector<std::uint32_t> list = before;
        read_difference(reader, list);
        ASSERT_EQ(list, after);
        ASSERT_TRUE(reader.is_at_end());
        ASSERT_LE(message.bytes().size(), 4 * after.size() + 6 * before.size() + 16);
    }
    MessageWriter same;
    write_difference(same, std::vector<std::uint32_t>{1, 2, 3},
                     std::vector<std::uint32_t>{1, 2, 3});
    EXPECT_EQ(same.bytes().size(), 1U);
}

TEST(RanksFailures, MessagesThatEndTooEarlyAreRefused) {
    MessageWriter message;
    message.list(std::vector<std::uint32_t>{1, 2, 3});
    for (std::size_t size = 0; size < message.bytes().size(); ++size) {
        MessageReader reader(message.bytes().first(size));
        std::vector<std::uint32_t> list;
        EXPECT_THROW(reader.list(list), InvariantError) << size;
    }
}

TEST(RanksFailures, SharesAreWholeInOrderAndOfAboutTheSameWork) {
    const std::vector<std::uint64_t> work{100, 100, 300, 100, 0, 100, 100};
    for (const std::uint32_t ranks : {1U, 2U, 3U, 4U, 20U}) {
        const auto shares = share_out(work, ranks);
        ASSERT_EQ(shares.size(), ranks);
        std::size_t at = 0;
        for (const ShareOfRank& share : shares) {
            EXPECT_EQ(share.begin, at);
            EXPECT_LE(share.begin, share.end);
            at = share.end;
        }
        EXPECT_EQ(at, work.size());
    }
    EXPECT_EQ(share_out(work, 2)[0].end, 3U);
    EXPECT_EQ(share_out(std::vector<std::uint64_t>(8, 0), 4)[2].begin, 4U);
}

} // namespace
} // namespace dsc::ranks_failures_test
