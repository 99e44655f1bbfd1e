// Made from the API's document by `npm run types --prefix page`.

export interface paths {
    "/": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A page to watch and move the arm */
        get: operations["get_page"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/page.css": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** How the page looks */
        get: operations["get_page_css"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/page.js": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** What the page does */
        get: operations["get_page_js"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/preview.js": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Shows a drawing in time */
        get: operations["get_preview_js"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/timeline.js": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** What is at a moment of a drawing */
        get: operations["get_timeline_js"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/reader.js": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Reads the timeline of a drawing */
        get: operations["get_reader_js"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/look.js": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** How a drawing in time looks */
        get: operations["get_look_js"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/sketch.js": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Draws a drawing in time */
        get: operations["get_sketch_js"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/openapi.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** This document */
        get: operations["get_openapi_json"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/problems/{kind}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Explains a kind of problem */
        get: operations["get_problems_kind"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/state": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** What the station knows now */
        get: operations["get_state"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/notices": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** What happened lately, the oldest first */
        get: operations["get_notices"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/policy": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The safety policy, as `dobot policy` shows it */
        get: operations["get_policy"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/ws": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A WebSocket for states, notices and requests. The station sends messages as in `ToClient`, the client as in `FromClient`, both as text. The lease of the client ends with the connection. A browser, which cannot send headers, offers the subprotocols `dobot` and `dobot.token.<token>`. */
        get: operations["get_ws"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/commands": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Sends one command, if the policy allows its whole way */
        post: operations["post_commands"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jog": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Holds a jog button; it is released when this is not said again within the dead-man time (150 ms by default) */
        post: operations["post_jog"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jog/release": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Releases the jog button */
        post: operations["post_jog_release"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/stop": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Stops the arm. Anyone may, at any time, without a lease */
        post: operations["post_stop"];
        /** Lets the arm move again after a stop: a person has looked at it */
        delete: operations["delete_stop"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/lease": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Takes control, if nobody has it; with a lease token it renews the lease */
        post: operations["post_lease"];
        /** Gives control back */
        delete: operations["delete_lease"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/lease/ask": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Asks the holder for control; the state tells when it is granted */
        post: operations["post_lease_ask"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/lease/grant": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Gives control to one who asked */
        post: operations["post_lease_grant"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/lease/seize": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Takes control from whoever has it (admin) */
        post: operations["post_lease_seize"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/laser": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Lets the laser be switched on for a while: a person has put the goggles on */
        post: operations["post_laser"];
        /** Switches the laser off and keeps it off */
        delete: operations["delete_laser"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/pose/confirm": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** The arm stands where its statuses say: a person has looked */
        post: operations["post_pose_confirm"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/dialect": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /** Says which dialect the arm speaks (admin) */
        put: operations["put_dialect"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/dialect/detect": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Finds out which dialect the arm speaks, by small slow motions */
        post: operations["post_dialect_detect"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** All jobs, the oldest first */
        get: operations["get_jobs"];
        put?: never;
        /** Queues a job */
        post: operations["post_jobs"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** One job */
        get: operations["get_jobs_id"];
        put?: never;
        post?: never;
        /** Ends a job for good */
        delete: operations["delete_jobs_id"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/start": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Starts a queued job, or goes on with a paused one */
        post: operations["post_jobs_id_start"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/step": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Does the next step of a queued or paused job, and pauses behind it */
        post: operations["post_jobs_id_step"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/pause": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Pauses the running job after what the arm has got already */
        post: operations["post_jobs_pause"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/speed": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /** Draws the vectors of the job faster or slower than planned, from the next one on that is not sent yet */
        put: operations["put_jobs_speed"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/height": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /** Draws the job higher or lower than planned, gently, from the next command on that is not sent yet */
        put: operations["put_jobs_height"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
}
export type webhooks = Record<string, never>;
export interface components {
    schemas: {
        /** @description A refusal as a problem document (RFC 9457, `application/problem+json`). */
        Problem: {
            /** @description The kind of problem; the address tells about it. */
            type: string;
            /** @description The kind of problem in words. */
            title: string;
            /**
             * Format: uint16
             * @description The HTTP status.
             */
            status: number;
            /** @description What is wrong: where, what was found, what is allowed. */
            detail: string;
            /** @description What to do about it. */
            hint?: string | null;
            /** @description Which rule of the policy was broken. */
            rule?: string | null;
            /** @description Where on its way a motion would break the rule: x, y, z in millimetres. */
            at_mm?: number[] | null;
            /** @description The nearest place that is allowed: x, y, z in millimetres. */
            nearest_mm?: number[] | null;
        };
        /** @description A kind of problem, explained. */
        ProblemKind: {
            /** @description Its name: the last part of the problem type's address. */
            kind: string;
            /** @description The problem in words. */
            title: string;
            /**
             * Format: uint16
             * @description The HTTP status that comes with it.
             */
            status: number;
            /** @description What it means and what helps. */
            explanation: string;
        };
        /** @description All that the station knows at one moment. */
        State: {
            /**
             * Format: double
             * @description The time since the station started, in seconds.
             */
            at_s: number;
            /** @description The way to the arm. */
            link: components["schemas"]["LinkView"];
            /** @description What the arm told last; absent until it has told anything. */
            arm?: components["schemas"]["ArmView"] | null;
            /** @description The dialect that the arm speaks, if that is known. */
            dialect?: components["schemas"]["Dialect"] | null;
            /** @description Whether the pose can be trusted. */
            trust: components["schemas"]["TrustView"];
            /** @description What the arm has still to do. */
            queue: components["schemas"]["QueueView"];
            /** @description Who has control, if anybody has. */
            lease?: components["schemas"]["LeaseView"] | null;
            /** @description The stop that holds the arm, if one does. */
            stop?: components["schemas"]["StopView"] | null;
            /** @description The laser's interlock. */
            laser: components["schemas"]["LaserView"];
            /** @description The job that runs or is paused. */
            job?: components["schemas"]["JobView"] | null;
            /**
             * Format: uint
             * @description How many clients are connected.
             */
            clients: number;
        };
        /** @description The way to the arm. */
        LinkView: {
            /** @description Where the arm is reached: an address, or nothing yet. */
            address?: string | null;
            /** @description How far the link is. */
            phase: components["schemas"]["LinkPhase"];
            /** @description What is wrong with it and what to do, if anything is. */
            problem?: string | null;
            /**
             * @description Whether it leads to the Bluetooth port of a stock arm: its statuses tell so, and joint jogs have
             *     other axes there, to which they are translated.
             * @default false
             */
            bluetooth: boolean;
            /**
             * Format: double
             * @description Statuses in a second, of 12.5; of 18.75 over Bluetooth.
             */
            statuses_per_s: number;
            /**
             * Format: uint64
             * @description Statuses that should have come and did not, since the connect.
             */
            lost_statuses: number;
            /**
             * Format: uint64
             * @description Bytes that belong to no status, since the connect.
             */
            damaged_bytes: number;
            /**
             * Format: double
             * @description From a command to the first status that shows it, in milliseconds, where that is known.
             */
            latency_ms?: number | null;
        };
        /** @description How far the link is. */
        LinkPhase: "searching" | "listening" | "up" | "lost";
        /** @description What the arm told last. */
        ArmView: {
            /**
             * Format: float
             * @description Forward of the base's axis, in millimetres.
             */
            x_mm: number;
            /**
             * Format: float
             * @description To the left of it, in millimetres.
             */
            y_mm: number;
            /**
             * Format: float
             * @description Above the rear arm's pivot, in millimetres.
             */
            z_mm: number;
            /**
             * Format: float
             * @description The end effector's rotation relative to the base, in degrees: servo plus base angle.
             */
            rotation_deg: number;
            /**
             * Format: float
             * @description The base's angle in degrees, counter-clockwise seen from above.
             */
            base_deg: number;
            /**
             * Format: float
             * @description The rear arm's angle in degrees from the vertical, forward positive.
             */
            rear_deg: number;
            /**
             * Format: float
             * @description The forearm's angle in degrees below the horizontal.
             */
            fore_deg: number;
            /**
             * Format: float
             * @description The servo's angle in degrees.
             */
            servo_deg: number;
            /** @description Whether the pump runs; the laser does not show (note N21). */
            suction: boolean;
            /**
             * Format: float
             * @description The gripper's angle in degrees.
             */
            gripper_deg: number;
            /** @description Whether it moves. */
            moving: boolean;
        };
        /**
         * @description What the packets mean: as the published document says, or as stock arms do (firmware 1.1).
         * @enum {string}
         */
        Dialect: "specification" | "firmware-1.1";
        /** @description Whether the pose can be trusted. */
        TrustView: {
            /** @description It can. */
            trusted: boolean;
            /** @description Why not. */
            reason?: string | null;
        };
        /** @description What the arm has still to do. */
        QueueView: {
            /**
             * Format: uint
             * @description Commands that wait in the station.
             */
            waiting: number;
            /**
             * Format: uint
             * @description Commands sent and not seen to be over.
             */
            under_way: number;
            /**
             * Format: double
             * @description How long those under way still take, in seconds, by the motion model.
             */
            ahead_s: number;
        };
        /** @description Who has control of the arm. */
        LeaseView: {
            /** @description The holder. */
            client: components["schemas"]["ClientId"];
            /** @description What the holder calls itself. */
            name: string;
            /**
             * @description Whether the holder is a program on the raw port, which cannot be asked: an administrator takes
             *     control from it.
             * @default false
             */
            is_program: boolean;
            /**
             * Format: double
             * @description Since when, in seconds since the station started.
             */
            since_s: number;
            /** @description Who asks for control. */
            asked_by: components["schemas"]["Asking"][];
        };
        /**
         * Format: uint64
         * @description Names a client of the station while it is connected.
         */
        ClientId: number;
        /** @description Somebody who asks for control. */
        Asking: {
            /** @description Who. */
            client: components["schemas"]["ClientId"];
            /** @description What it calls itself. */
            name: string;
        };
        /** @description A stop that holds the arm. */
        StopView: {
            /** @description Who stopped it. */
            by: string;
            /** @description Why. */
            reason?: string | null;
            /**
             * Format: double
             * @description When, in seconds since the station started.
             */
            at_s: number;
            /**
             * Format: double
             * @description By when the arm was promised to be at rest, in seconds since the station started.
             */
            rests_by_s: number;
            /** @description Whether it has been seen at rest since. */
            at_rest: boolean;
        };
        /** @description The laser's interlock. */
        LaserView: {
            /**
             * Format: double
             * @description For how long it may still be switched on, in seconds; 0 when it is disarmed.
             */
            armed_for_s: number;
            /**
             * @description Whether the laser of the arm may be on, as its dialect has it: from when it was sent what burns
             *     until that is over, or what switches the laser off had time to act.
             */
            on: boolean;
        };
        /** @description A job, as it is now. */
        JobView: {
            /**
             * Format: uint64
             * @description Its number.
             */
            job: number;
            /** @description What a person calls it. */
            title: string;
            /** @description What kind of job. */
            kind: components["schemas"]["JobKind"];
            /** @description How far it is. */
            phase: components["schemas"]["JobPhase"];
            /** @description Why it is paused, stopped or failed. */
            reason?: string | null;
            /**
             * Format: uint
             * @description How many commands it has; those of a cycle count once.
             */
            commands: number;
            /**
             * Format: uint
             * @description How many of them are over, in this cycle.
             */
            completed: number;
            /**
             * Format: double
             * @description How long all of it takes, in seconds, by the motion model, where that has been looked at.
             */
            planned_s?: number | null;
            /**
             * Format: double
             * @description How long the rest takes, in seconds, by the motion model, where that has been looked at; at
             *     another speed than planned that is an estimate.
             */
            left_s?: number | null;
            /**
             * Format: double
             * @description How long all of it really took, in seconds, without pauses; of a job that is done, where no
             *     crash came between.
             */
            took_s?: number | null;
            /**
             * Format: double
             * @description How fast its vectors are drawn, in percent of what was planned.
             */
            speed_percent: number;
            /**
             * Format: double
             * @description How far above the plan it is drawn, in millimetres.
             */
            height_mm: number;
            /** @description How far it is in its steps and cycles, if it is a program. */
            program?: components["schemas"]["ProgramView"] | null;
        };
        /** @description What kind of job. */
        JobKind: "drawing" | "program";
        /** @description How far a job is. */
        JobPhase: "queued" | "running" | "paused" | "stopped" | "done" | "failed";
        /** @description How far a program is in its steps and cycles. */
        ProgramView: {
            /**
             * Format: uint
             * @description How many steps it has.
             */
            steps: number;
            /**
             * Format: uint
             * @description The step that it is at, counted from 0; the number of steps where all are over.
             */
            step: number;
            /**
             * Format: uint64
             * @description How many cycles are over.
             */
            cycles_done: number;
            /**
             * Format: uint64
             * @description How many it does in all; none where it goes on until a person ends it.
             */
            cycles?: number | null;
            /**
             * Format: double
             * @description How long a cycle takes, in seconds, by the motion model.
             */
            planned_cycle_s?: number | null;
            /**
             * Format: double
             * @description How long a cycle really took, in seconds, without pauses: the mean of those that were done in one go
             *     since the job was started last.
             */
            mean_cycle_s?: number | null;
        };
        /** @description Something that happened, for all who watch. */
        Notice: {
            /**
             * Format: uint64
             * @description Its number, from 1.
             */
            number: number;
            /**
             * Format: double
             * @description When, in seconds since the station started.
             */
            at_s: number;
            /** @description The same for a person, in one line. */
            text: string;
        } & ({
            /** @constant */
            type: "link_up";
        } | {
            /** @constant */
            type: "link_lost";
        } | {
            /** @constant */
            type: "reset";
        } | {
            /** @constant */
            type: "pose_trusted";
        } | {
            /** @constant */
            type: "dialect_known";
            /** @description The dialect. */
            dialect: components["schemas"]["Dialect"];
        } | {
            /** @constant */
            type: "command_done";
            /**
             * Format: uint64
             * @description Its number.
             */
            command: number;
        } | {
            /** @constant */
            type: "command_failed";
            /**
             * Format: uint64
             * @description Its number.
             */
            command: number;
        } | {
            /** @constant */
            type: "pausing";
            /**
             * Format: uint64
             * @description The number of the command.
             */
            command: number;
            /**
             * Format: double
             * @description How long, in seconds.
             */
            lasts_s: number;
        } | {
            /** @constant */
            type: "refused";
            /** @description Who asked. */
            client: components["schemas"]["ClientId"];
            /** @description The kind of refusal, as in the problem documents. */
            kind: string;
        } | {
            /** @constant */
            type: "amended";
            /** @description Who. */
            client: components["schemas"]["ClientId"];
        } | {
            /** @constant */
            type: "lease_taken";
            /** @description Who. */
            client: components["schemas"]["ClientId"];
        } | {
            /** @constant */
            type: "lease_asked";
            /** @description Who. */
            client: components["schemas"]["ClientId"];
        } | {
            /** @constant */
            type: "lease_free";
        } | {
            /** @constant */
            type: "stopped";
        } | {
            /** @constant */
            type: "at_rest";
        } | {
            /** @constant */
            type: "stop_reset";
        } | {
            /** @constant */
            type: "laser_armed";
        } | {
            /** @constant */
            type: "laser_disarmed";
        } | {
            /** @constant */
            type: "laser_off";
        } | {
            /** @constant */
            type: "dead_man";
        } | {
            /** @constant */
            type: "job";
            /**
             * Format: uint64
             * @description Its number.
             */
            job: number;
            /** @description How far it is now. */
            phase: components["schemas"]["JobPhase"];
        } | {
            /** @constant */
            type: "trouble";
        });
        /**
         * @description What no command of any client may do.
         *
         *     What a file does not say is as in [`Policy::DEFAULT_TOML`], which is [`Policy::default`].
         */
        Policy: {
            /**
             * @description How far each joint may turn.
             * @default {
             *       "base_deg": [
             *         -135,
             *         135
             *       ],
             *       "rear_deg": [
             *         -5,
             *         85
             *       ],
             *       "fore_deg": [
             *         -10,
             *         95
             *       ],
             *       "servo_deg": [
             *         -90,
             *         90
             *       ],
             *       "opening_deg": [
             *         -105,
             *         35
             *       ]
             *     }
             */
            joints: components["schemas"]["JointLimits"];
            /**
             * @description Where the tool may be.
             * @default {
             *       "x_mm": [
             *         -321,
             *         321
             *       ],
             *       "y_mm": [
             *         -321,
             *         321
             *       ],
             *       "z_mm": [
             *         -103,
             *         136
             *       ],
             *       "reach_mm": [
             *         129,
             *         321
             *       ]
             *     }
             */
            workspace: components["schemas"]["Workspace"];
            /**
             * @description What the tool tip may not go into.
             * @default {
             *       "z_mm": -103
             *     }
             */
            table: components["schemas"]["Table"];
            /**
             * @description How far each tool hangs down.
             * @default {
             *       "suction_cup_mm": 40,
             *       "gripper_mm": 40,
             *       "laser_mm": 38
             *     }
             */
            tool_length: components["schemas"]["ToolLengths"];
            /**
             * @description How thick the arm is.
             * @default {
             *       "radius_mm": 20
             *     }
             */
            arm: components["schemas"]["ArmBody"];
            /**
             * @description What no part of the arm may touch, by name.
             * @default {}
             */
            keep_out: {
                [key: string]: components["schemas"]["KeepOut"];
            };
            /**
             * @description The highest speeds.
             * @default {
             *       "joint_deg_s": 200,
             *       "servo_deg_s": 200,
             *       "line_mm_s": 200,
             *       "writing_mm_s": 200,
             *       "jog_percent": 100
             *     }
             */
            speed: components["schemas"]["SpeedCeilings"];
            /**
             * @description The highest accelerations.
             * @default {
             *       "joint_deg_s2": 500,
             *       "servo_deg_s2": 500,
             *       "line_mm_s2": 500,
             *       "writing_mm_s2": 500
             *     }
             */
            acceleration: components["schemas"]["AccelerationCeilings"];
            /**
             * @description JUMP moves.
             * @default {
             *       "height_mm": 150
             *     }
             */
            jump: components["schemas"]["JumpRules"];
            /**
             * @description When and where the laser may burn.
             * @default {
             *       "allowed": true,
             *       "arm_for_s": 600,
             *       "least_speed_mm_s": 1,
             *       "standing": false,
             *       "area": {
             *         "x_mm": [
             *           130,
             *           321
             *         ],
             *         "y_mm": [
             *           -200,
             *           200
             *         ],
             *         "z_mm": [
             *           -103,
             *           60
             *         ]
             *       }
             *     }
             */
            laser: components["schemas"]["LaserRules"];
            /**
             * @description Jogs.
             * @default {
             *       "dead_man_s": 0.15,
             *       "raw_dead_man_s": 1.2,
             *       "reaction_s": 0.25
             *     }
             */
            jog: components["schemas"]["JogRules"];
            /**
             * @description What waits in the arm.
             * @default {
             *       "ahead_s": 0.5
             *     }
             */
            queue: components["schemas"]["QueueRules"];
        };
        /** @description How far each joint may turn, in degrees; never further than the arm itself can. */
        JointLimits: {
            /**
             * @description Joint 1: -180 to 180 at most, though the cables want no more than 135.
             * @default [
             *       -135,
             *       135
             *     ]
             */
            base_deg: components["schemas"]["Bounds"];
            /**
             * @description Joint 2, from the vertical, forward positive: -5 to 85 at most.
             * @default [
             *       -5,
             *       85
             *     ]
             */
            rear_deg: components["schemas"]["Bounds"];
            /**
             * @description Joint 3, below the horizontal: -10 to 95 at most.
             * @default [
             *       -10,
             *       95
             *     ]
             */
            fore_deg: components["schemas"]["Bounds"];
            /**
             * @description Joint 4: -90 to 90 at most.
             * @default [
             *       -90,
             *       90
             *     ]
             */
            servo_deg: components["schemas"]["Bounds"];
            /**
             * @description Joint 2 minus joint 3, how far the elbow opens: -105 to 35 at most.
             * @default [
             *       -105,
             *       35
             *     ]
             */
            opening_deg: components["schemas"]["Bounds"];
        };
        /** @description The least and the most that is allowed; both are allowed. In a file: `[min, max]`. */
        Bounds: number[];
        /** @description Where the tool may be, in mm: x, y and z as the arm tells them (z is the height of the wrist). */
        Workspace: {
            /**
             * @description Forward: -321 to 321 at most.
             * @default [
             *       -321,
             *       321
             *     ]
             */
            x_mm: components["schemas"]["Bounds"];
            /**
             * @description To the left: -321 to 321 at most.
             * @default [
             *       -321,
             *       321
             *     ]
             */
            y_mm: components["schemas"]["Bounds"];
            /**
             * @description Up: -300 to 136 at most.
             * @default [
             *       -103,
             *       136
             *     ]
             */
            z_mm: components["schemas"]["Bounds"];
            /**
             * @description Horizontally from the axis of the base: 129 to 321 at most.
             * @default [
             *       129,
             *       321
             *     ]
             */
            reach_mm: components["schemas"]["Bounds"];
        };
        /** @description The table, which no tool tip may go into. */
        Table: {
            /**
             * Format: double
             * @description The height of its surface in the base frame, in mm: -300 to 136.
             * @default -103
             */
            z_mm: number;
        };
        /** @description How far the tip of each tool hangs below the wrist, in mm: 0 to 200. */
        ToolLengths: {
            /**
             * Format: double
             * @description The suction cup; the pen too.
             * @default 40
             */
            suction_cup_mm: number;
            /**
             * Format: double
             * @description The gripper.
             * @default 40
             */
            gripper_mm: number;
            /**
             * Format: double
             * @description The laser.
             * @default 38
             */
            laser_mm: number;
        };
        /** @description How thick the arm is where keep-outs are concerned. */
        ArmBody: {
            /**
             * Format: double
             * @description How much arm there is around the lines through its links, in mm: 0 to 100.
             * @default 20
             */
            radius_mm: number;
        };
        /** @description What no part of the arm may touch. */
        KeepOut: {
            box: components["schemas"]["Area"];
        } | {
            cylinder: components["schemas"]["Cylinder"];
        };
        /** @description A box along the axes of the base frame, in mm. */
        Area: {
            /** @description From back to front. */
            x_mm: components["schemas"]["Bounds"];
            /** @description From right to left. */
            y_mm: components["schemas"]["Bounds"];
            /** @description From bottom to top. */
            z_mm: components["schemas"]["Bounds"];
        };
        /** @description An upright cylinder, in mm. */
        Cylinder: {
            /**
             * Format: double
             * @description Its axis: forward.
             */
            x_mm: number;
            /**
             * Format: double
             * @description Its axis: to the left.
             */
            y_mm: number;
            /**
             * Format: double
             * @description Its radius, 0 or more.
             */
            radius_mm: number;
            /** @description From bottom to top. */
            z_mm: components["schemas"]["Bounds"];
        };
        /** @description The highest speeds: what is configured times its percentage. */
        SpeedCeilings: {
            /**
             * Format: double
             * @description Base, rear arm and forearm, in degrees/s: above 0 to 1000.
             * @default 200
             */
            joint_deg_s: number;
            /**
             * Format: double
             * @description The servo, in degrees/s: above 0 to 1000.
             * @default 200
             */
            servo_deg_s: number;
            /**
             * Format: double
             * @description The tool, in mm/s: above 0 to 1000.
             * @default 200
             */
            line_mm_s: number;
            /**
             * Format: double
             * @description Writing and laser vectors, in mm/s: above 0 to 1000.
             * @default 200
             */
            writing_mm_s: number;
            /**
             * Format: double
             * @description The percentage of a jog: 1 to 100.
             * @default 100
             */
            jog_percent: number;
        };
        /** @description The highest accelerations: what is configured times its percentage. */
        AccelerationCeilings: {
            /**
             * Format: double
             * @description Base, rear arm and forearm, in degrees/s2: above 0 to 10000.
             * @default 500
             */
            joint_deg_s2: number;
            /**
             * Format: double
             * @description The servo, in degrees/s2: above 0 to 10000.
             * @default 500
             */
            servo_deg_s2: number;
            /**
             * Format: double
             * @description The tool, in mm/s2: above 0 to 10000.
             * @default 500
             */
            line_mm_s2: number;
            /**
             * Format: double
             * @description Writing and laser vectors, in mm/s2: above 0 to 10000.
             * @default 500
             */
            writing_mm_s2: number;
        };
        /** @description JUMP moves. */
        JumpRules: {
            /**
             * Format: double
             * @description The highest that may be configured, in mm: 0 to 300.
             * @default 150
             */
            height_mm: number;
        };
        /** @description When and where the laser may burn. */
        LaserRules: {
            /**
             * @description Whether anything may light it at all.
             * @default true
             */
            allowed: boolean;
            /**
             * Format: double
             * @description For how long a person arms it at most, in s: 1 to 3600.
             * @default 600
             */
            arm_for_s: number;
            /**
             * Format: double
             * @description The least of the largest speed of a burning vector, in mm/s: 0 to 1000.
             * @default 1
             */
            least_speed_mm_s: number;
            /**
             * @description Whether it may burn while the arm stands.
             * @default false
             */
            standing: boolean;
            /**
             * @description Where it may burn: x, y and z as the arm tells them.
             * @default {
             *       "x_mm": [
             *         130,
             *         321
             *       ],
             *       "y_mm": [
             *         -200,
             *         200
             *       ],
             *       "z_mm": [
             *         -103,
             *         60
             *       ]
             *     }
             */
            area: components["schemas"]["Area"];
        };
        /** @description Jogs, which go on until they are told otherwise. */
        JogRules: {
            /**
             * Format: double
             * @description After this long without a word from the client a jog is released, in s: 0.05 to 2.
             * @default 0.15
             */
            dead_man_s: number;
            /**
             * Format: double
             * @description The same for old programs on the raw port, which repeat every 0.5 s, in s: 0.05 to 5.
             * @default 1.2
             */
            raw_dead_man_s: number;
            /**
             * Format: double
             * @description How long it takes from a place to the release in force, in s: 0.05 to 2.
             * @default 0.25
             */
            reaction_s: number;
        };
        /** @description What waits in the arm. */
        QueueRules: {
            /**
             * Format: double
             * @description How long before the arm should begin a command it may be sent, in s: 0 to 60. So long after a stop
             *     the arm may begin another motion.
             * @default 0.5
             */
            ahead_s: number;
        };
        /** @description A command to be sent. */
        NewCommand: {
            /** @description The command. */
            command: components["schemas"]["Command"];
            /**
             * @description Answer when the command is over, instead of as soon as it waits for its turn.
             * @default false
             */
            wait: boolean;
        };
        /** @description Everything that a client can say (Table 2.2). */
        Command: {
            /** @constant */
            type: "mouse_move";
            /**
             * Format: float
             * @description How far along Y; on a stock arm the base swings by -0.225 degrees for each unit.
             */
            y: number;
            /**
             * Format: float
             * @description How far along X; on a stock arm the reach grows by 0.4 mm for each unit.
             */
            x: number;
            /**
             * Format: float
             * @description How far along Z; on a stock arm 0.4 mm for each unit.
             */
            z: number;
            /**
             * Format: float
             * @description The rotation of the end effector, absolute, in degrees (note N9).
             */
            rotation_deg: number;
            /** @description Whether the pump runs. */
            suction: boolean;
        } | {
            /** @constant */
            type: "joint_jog";
            /** @description What the button moves or switches. */
            axis: components["schemas"]["JointJogAxis"];
            /**
             * Format: float
             * @description The speed in percent of the largest: 1 to 100, and 0 too for a release or a switch.
             */
            speed_percent: number;
        } | {
            /** @constant */
            type: "move_to";
            /**
             * Format: float
             * @description Forward of the base's axis, in millimetres.
             */
            x_mm: number;
            /**
             * Format: float
             * @description To the left of it, in millimetres.
             */
            y_mm: number;
            /**
             * Format: float
             * @description Above the rear arm's pivot, in millimetres.
             */
            z_mm: number;
            /**
             * Format: float
             * @description The end effector's rotation relative to the base, in degrees: servo plus base angle, not the
             *     joint 4 angle.
             */
            rotation_deg: number;
            /** @description Whether the pump runs after the move. */
            suction: boolean;
            /** @description The way there. */
            mode: components["schemas"]["MovingMode"];
            /**
             * Format: float
             * @description The gripper's angle after the move, -90 to 90 degrees.
             */
            gripper_deg: number;
            /**
             * Format: float
             * @description The pause after the move, 0 to 655 seconds (note N10).
             */
            pause_s: number;
        } | {
            /** @constant */
            type: "write_vector";
            /** @description Pen or laser. */
            mode: components["schemas"]["WriteMode"];
            /**
             * Format: float
             * @description How far along X in the arm's frame, in millimetres, whatever the dialect's sign (note N4).
             */
            x_mm: number;
            /**
             * Format: float
             * @description How far along Y, in millimetres.
             */
            y_mm: number;
            /**
             * Format: float
             * @description How far along Z, in millimetres.
             */
            z_mm: number;
            /** @description Whether the laser is on. */
            laser: boolean;
            /**
             * Format: float
             * @description The speed at the start, 0 or above, in mm/s (note N5).
             */
            start_speed_mm_s: number;
            /**
             * Format: float
             * @description The speed at the end, 0 or above, in mm/s.
             */
            end_speed_mm_s: number;
            /**
             * Format: float
             * @description The largest speed on the way, above 0, in mm/s.
             */
            max_speed_mm_s: number;
            /** @description Laser off and no motion; only some dialects have it (note N7). */
            stop: boolean;
        } | {
            /** @constant */
            type: "voice";
            /** @description The text, filled up with zeros. */
            text: string;
        } | {
            /** @constant */
            type: "move_joints";
            /**
             * Format: float
             * @description The base's angle (joint 1) in degrees, counter-clockwise seen from above.
             */
            base_deg: number;
            /**
             * Format: float
             * @description The rear arm's angle (joint 2) in degrees from the vertical, forward positive.
             */
            rear_deg: number;
            /**
             * Format: float
             * @description The forearm's angle (joint 3) in degrees below the horizontal.
             */
            fore_deg: number;
            /**
             * Format: float
             * @description The servo's angle (joint 4) in degrees; 0 is parallel to the forearm (note N19).
             */
            servo_deg: number;
            /** @description Whether the pump runs after the move. */
            suction: boolean;
            /** @description The way there. */
            mode: components["schemas"]["MovingMode"];
            /**
             * Format: float
             * @description The gripper's angle after the move, -90 to 90 degrees.
             */
            gripper_deg: number;
            /**
             * Format: float
             * @description The pause after the move, 0 to 655 seconds (note N10).
             */
            pause_s: number;
        } | {
            /** @constant */
            type: "linear_jog";
            /** @description What the button moves or switches. */
            axis: components["schemas"]["LinearJogAxis"];
            /**
             * Format: float
             * @description The speed in percent of the largest: 1 to 100, and 0 too for a release or a switch.
             */
            speed_percent: number;
        } | {
            /** @constant */
            type: "gesture";
            /**
             * Format: float
             * @description The hand's position along X.
             */
            x: number;
            /**
             * Format: float
             * @description The hand's position along Y.
             */
            y: number;
            /**
             * Format: float
             * @description The hand's position along Z.
             */
            z: number;
            /** @description Whether the hand is closed: pump and gripper act together. */
            grab: boolean;
        } | ({
            /** @constant */
            type: "configuration";
        } & ({
            /** @constant */
            mode: "teach";
            /**
             * Format: float
             * @description The speed of base, rear arm and forearm, in degrees/s.
             */
            joint_speed_deg_s: number;
            /**
             * Format: float
             * @description Their acceleration, in degrees/s2.
             */
            joint_acceleration_deg_s2: number;
            /**
             * Format: float
             * @description The speed of the servo (joint 4), in degrees/s.
             */
            servo_speed_deg_s: number;
            /**
             * Format: float
             * @description Its acceleration, in degrees/s2.
             */
            servo_acceleration_deg_s2: number;
            /**
             * Format: float
             * @description The speed along an axis, in mm/s.
             */
            linear_speed_mm_s: number;
            /**
             * Format: float
             * @description The acceleration along an axis, in mm/s2.
             */
            linear_acceleration_mm_s2: number;
        } | {
            /** @constant */
            mode: "playback";
            /**
             * Format: float
             * @description The largest speed of base, rear arm and forearm, in degrees/s.
             */
            joint_speed_deg_s: number;
            /**
             * Format: float
             * @description Their largest acceleration, in degrees/s2.
             */
            joint_acceleration_deg_s2: number;
            /**
             * Format: float
             * @description The largest speed of the servo, in degrees/s.
             */
            servo_speed_deg_s: number;
            /**
             * Format: float
             * @description Its largest acceleration, in degrees/s2.
             */
            servo_acceleration_deg_s2: number;
            /**
             * Format: float
             * @description The largest speed along a line, in mm/s.
             */
            linear_speed_mm_s: number;
            /**
             * Format: float
             * @description The largest acceleration along a line, in mm/s2.
             */
            linear_acceleration_mm_s2: number;
            /**
             * Format: float
             * @description The pause of targets that have none, 0 to 655 seconds (note N10).
             */
            default_pause_s: number;
            /**
             * Format: float
             * @description How high a JUMP lifts, 0 or above, in millimetres (note N11).
             */
            jump_height_mm: number;
        } | {
            /** @constant */
            mode: "writing";
            /**
             * Format: float
             * @description The acceleration, in mm/s2.
             */
            acceleration_mm_s2: number;
        } | {
            /** @constant */
            mode: "initial_angles";
            /**
             * Format: float
             * @description The rear arm's angle in degrees from the vertical, whatever the dialect's form.
             */
            rear_deg: number;
            /**
             * Format: float
             * @description The forearm's angle in degrees below the horizontal.
             */
            fore_deg: number;
        } | {
            /** @constant */
            mode: "end_effector";
            /** @description The tool. */
            tool: components["schemas"]["EndEffector"];
        })) | {
            /** @constant */
            type: "playback_adjustment";
            /**
             * Format: float
             * @description The speed of targets in percent of the configured one, above 0 to 100.
             */
            speed_percent: number;
            /**
             * Format: float
             * @description The acceleration of targets in percent of the configured one, above 0 to 100.
             */
            acceleration_percent: number;
            /**
             * Format: float
             * @description The speed of jogs in percent, above 0 to 100; each jog carries its own too (note N15).
             */
            teach_speed_percent: number;
        };
        /** @description What a button of joint jog moves or switches (Table 2.5; note N14). */
        JointJogAxis: "released" | "base_plus" | "base_minus" | "rear_plus" | "rear_minus" | "fore_plus" | "fore_minus" | "servo_plus" | "servo_minus" | "suction_on" | "suction_off" | "gripper_open" | "gripper_close" | "laser_on" | "laser_off";
        /** @description The way to a target (float 8 of states 3 and 6; Table 3.7). */
        MovingMode: "jump" | "movl" | "movj";
        /** @description Pen or laser (float 2 of state 4; Table 2.6). */
        WriteMode: "writing" | "laser";
        /** @description What a button of linear jog moves or switches (Table 2.5; note N14). */
        LinearJogAxis: "released" | "x_plus" | "x_minus" | "y_plus" | "y_minus" | "z_plus" | "z_minus" | "servo_plus" | "servo_minus" | "suction_on" | "suction_off" | "gripper_open" | "gripper_close" | "laser_on" | "laser_off";
        /** @description What is mounted at the end of the arm (state 9, mode 4; Table 3.9). */
        EndEffector: "suction_cup" | "gripper" | "laser";
        /** @description The answer to a request that was granted. */
        Reply: {
            /** @constant */
            type: "done";
        } | {
            /** @constant */
            type: "accepted";
            /**
             * Format: uint64
             * @description Its number.
             */
            command: number;
            /**
             * Format: double
             * @description How long it and all before it take, in seconds, where that can be told.
             */
            takes_s?: number | null;
        } | {
            /** @constant */
            type: "stopping";
            /**
             * Format: double
             * @description By when the arm is at rest at the latest, in seconds.
             */
            rests_within_s: number;
        } | {
            /** @constant */
            type: "lease";
            /** @description Who has it, if anybody has. */
            lease?: components["schemas"]["LeaseView"] | null;
        } | {
            /** @constant */
            type: "job";
            /** @description The job. */
            job: components["schemas"]["JobView"];
        } | {
            /** @constant */
            type: "found";
            /** @description What was found, and by which evidence. */
            finding: components["schemas"]["Finding"];
        };
        /** @description Which dialect an arm speaks, and what shows it. */
        Finding: {
            /** @description The dialect. */
            dialect: components["schemas"]["Dialect"];
            /** @description An answer for each question that was put to the arm. */
            evidence: components["schemas"]["Evidence"][];
        };
        /** @description What an arm did where the dialects disagree. */
        Evidence: {
            /** @description What was asked, with the note that says why. */
            question: string;
            /** @description What the statuses told. */
            saw: string;
            /** @description The dialect of an arm that does so. */
            means: components["schemas"]["Dialect"];
        };
        /** @description A button. */
        HoldJog: {
            /** @description Which one. */
            jog: components["schemas"]["Jog"];
        };
        /** @description A jog button. */
        Jog: {
            /** @constant */
            frame: "joint";
            /** @description What the button moves or switches. */
            axis: components["schemas"]["JointJogAxis"];
            /**
             * Format: float
             * @description The speed in percent of the largest: 1 to 100, and 0 too for a release or a switch.
             */
            speed_percent: number;
        } | {
            /** @constant */
            frame: "linear";
            /** @description What the button moves or switches. */
            axis: components["schemas"]["LinearJogAxis"];
            /**
             * Format: float
             * @description The speed in percent of the largest: 1 to 100, and 0 too for a release or a switch.
             */
            speed_percent: number;
        };
        /** @description Nothing. */
        Nothing: Record<string, never>;
        /** @description A stop. */
        NewStop: {
            /**
             * @description Why, for those who find the arm stopped.
             * @default null
             */
            reason: string | null;
        };
        /** @description Who wants control. */
        LeaseRequest: {
            /**
             * @description What the client calls itself.
             * @default null
             */
            name: string | null;
        };
        /** @description Control, or the hope for it. */
        Granted: {
            /** @description What to send as header `Dobot-Lease` with all requests that go with it. */
            token: string;
            /**
             * Format: uint64
             * @description How long the token lasts without being used, in seconds.
             */
            lasts_s: number;
            /** @description Who has control now, if anybody has. */
            lease?: components["schemas"]["LeaseView"] | null;
        };
        /** @description Who is to get control. */
        HandOver: {
            /** @description One of those who ask. */
            to: components["schemas"]["ClientId"];
        };
        /** @description For how long the laser may be switched on. */
        ArmLaser: {
            /**
             * Format: double
             * @description In seconds.
             */
            for_s: number;
        };
        /** @description Which dialect the arm speaks. */
        UseDialect: {
            /** @description The dialect. */
            dialect: components["schemas"]["Dialect"];
        };
        /** @description A job to be queued. */
        NewJob: {
            /** @description What a person calls it. */
            title: string;
            /** @description What kind of job. */
            kind: components["schemas"]["JobKind"];
            /** @description What the arm is to do, in order. The first one that moves has to be a target (state 3 or 6). */
            commands: components["schemas"]["Command"][];
            /**
             * Format: float
             * @description How far the tool is lifted while the job is paused, in millimetres.
             * @default 0
             */
            lift_mm: number;
            /**
             * @description Where it waits for a person, in the order of its commands.
             * @default []
             */
            pauses: components["schemas"]["JobPause"][];
            /** @description How it goes through its commands, if it is a program. */
            program?: components["schemas"]["JobProgram"];
        };
        /** @description Where a job waits for a person: to change the pen, say. `start` goes on. */
        JobPause: {
            /**
             * Format: uint
             * @description The command before which it waits, counted from 0. The arm has to be at rest there.
             */
            before: number;
            /** @description What the person is told. */
            message: string;
        };
        /** @description How a job goes through its commands: in steps, and perhaps more than once. */
        JobProgram: {
            /** @description The first command of each step, in order; without them each command is a step. */
            steps?: number[];
            /** @description Which commands are done again. */
            repeat?: components["schemas"]["JobRepeat"] | null;
        };
        /** @description A cycle: the commands at the end of a job that are done again. */
        JobRepeat: {
            /**
             * Format: uint
             * @description The first of them, counted from 0; those before it are done once.
             */
            from: number;
            /**
             * Format: uint64
             * @description How often they are done in all; without it, until a person ends the job.
             */
            times?: number | null;
        };
        /** @description How fast a job is drawn. */
        Speed: {
            /**
             * Format: double
             * @description In percent of the planned speed.
             */
            percent: number;
        };
        /** @description How high a job is drawn. */
        Height: {
            /**
             * Format: double
             * @description How far above the plan, in millimetres; below 0 is lower.
             */
            offset_mm: number;
        };
        /** @description What the station sends over the WebSocket. */
        ToClient: {
            /** @description What the client has to know. */
            hello: components["schemas"]["Hello"];
        } | {
            /** @description The state. */
            state: components["schemas"]["State"];
        } | {
            /** @description What. */
            notice: components["schemas"]["Notice"];
        } | {
            /**
             * Format: uint64
             * @description The number of the request.
             */
            id: number;
            /** @description The answer. */
            reply: components["schemas"]["Reply"];
        } | {
            /**
             * Format: uint64
             * @description The number of the request, if it could be read.
             */
            id?: number | null;
            /** @description What is wrong. */
            problem: components["schemas"]["Problem"];
        };
        /** @description What a client has to know. */
        Hello: {
            /** @description The client's number. */
            client: components["schemas"]["ClientId"];
            /** @description What it may do. */
            role: components["schemas"]["Role"];
            /** @description The version of the station. */
            version: string;
            /**
             * Format: double
             * @description How long a jog button stays pressed without being said again, in seconds.
             */
            dead_man_s: number;
        };
        /** @description What a client may do; each role may do what those before it may. */
        Role: "watch" | "control" | "admin";
        /** @description What a client sends over the WebSocket. */
        FromClient: {
            /**
             * Format: uint64
             * @description A number by which the client recognises the answer.
             */
            id: number;
            /** @description What it asks for. */
            request: components["schemas"]["Request"];
        };
        /** @description What a client can ask of the station. */
        Request: {
            /** @constant */
            type: "command";
            /** @description The command. */
            command: components["schemas"]["Command"];
        } | {
            /** @constant */
            type: "jog";
            /** @description The button. */
            jog: components["schemas"]["Jog"];
        } | {
            /** @constant */
            type: "release";
        } | {
            /** @constant */
            type: "stop";
            /**
             * @description Why, for those who find the arm stopped. What is longer than 200 characters is cut: a stop
             *     is not refused.
             */
            reason?: string | null;
        } | {
            /** @constant */
            type: "reset_stop";
        } | {
            /** @constant */
            type: "take_lease";
        } | {
            /** @constant */
            type: "release_lease";
        } | {
            /** @constant */
            type: "ask_lease";
        } | {
            /** @constant */
            type: "grant_lease";
            /** @description Who gets it. */
            to: components["schemas"]["ClientId"];
        } | {
            /** @constant */
            type: "seize_lease";
        } | {
            /** @constant */
            type: "arm_laser";
            /**
             * Format: double
             * @description For how long, in seconds.
             */
            for_s: number;
        } | {
            /** @constant */
            type: "disarm_laser";
        } | {
            /** @constant */
            type: "confirm_pose";
        } | {
            /** @constant */
            type: "set_dialect";
            /** @description The dialect. */
            dialect: components["schemas"]["Dialect"];
        } | {
            /** @constant */
            type: "detect";
        } | {
            /** @constant */
            type: "submit_job";
            /** @description The job. */
            job: components["schemas"]["NewJob"];
        } | {
            /** @constant */
            type: "start_job";
            /**
             * Format: uint64
             * @description Its number.
             */
            job: number;
        } | {
            /** @constant */
            type: "step_job";
            /**
             * Format: uint64
             * @description Its number.
             */
            job: number;
        } | {
            /** @constant */
            type: "pause_job";
        } | {
            /** @constant */
            type: "set_job_speed";
            /**
             * Format: double
             * @description In percent of the planned speed.
             */
            percent: number;
        } | {
            /** @constant */
            type: "set_job_height";
            /**
             * Format: double
             * @description How far above the plan, in millimetres; below 0 is lower.
             */
            offset_mm: number;
        } | {
            /** @constant */
            type: "cancel_job";
            /**
             * Format: uint64
             * @description Its number.
             */
            job: number;
        };
    };
    responses: never;
    parameters: never;
    requestBodies: never;
    headers: never;
    pathItems: never;
}
export type $defs = Record<string, never>;
export interface operations {
    get_page: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the page */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/html": string;
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_page_css: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the style */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/css": string;
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_page_js: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the module */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/javascript": string;
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_preview_js: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the module */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/javascript": string;
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_timeline_js: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the module */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/javascript": string;
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_reader_js: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the module */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/javascript": string;
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_look_js: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the module */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/javascript": string;
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_sketch_js: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the module */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/javascript": string;
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_openapi_json: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description this document */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": unknown;
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_problems_kind: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                kind: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the kind */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProblemKind"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unknown-path`: there is nothing at this address */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_state: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the state */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["State"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_notices: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the notices */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Notice"][];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_policy: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the policy */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Policy"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_ws: {
        parameters: {
            query?: {
                /** @description The most states in a second, 0 to 1000; without it every one comes (12.5 in a second, and those with events) */
                states?: number;
                /** @description Whether notices come; true without it */
                notices?: boolean;
                /** @description What the client calls itself, in 1 to 60 characters */
                name?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the protocol changes to WebSocket */
            101: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `upgrade`: this address is a WebSocket */
            426: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many-clients`: too many clients
             *     - `too-many-requests`: too many requests
             */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_commands: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "command": {
                 *         "type": "move_to",
                 *         "x_mm": 200,
                 *         "y_mm": 0,
                 *         "z_mm": 50,
                 *         "rotation_deg": 0,
                 *         "suction": false,
                 *         "mode": "jump",
                 *         "gripper_deg": 0,
                 *         "pause_s": 0
                 *       },
                 *       "wait": true
                 *     }
                 */
                "application/json": components["schemas"]["NewCommand"];
            };
        };
        responses: {
            /** @description the arm is where the command leads (with `wait`) */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description the command waits for its turn */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm still moves
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job has the arm
             *     - `detecting`: the arm is finding out its dialect
             *     - `not-reached`: the command was taken, but the arm is not where it leads
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `command`: the command is not sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is not allowed
             *     - `invalid`: a field is not as it has to be
             */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many`: too much waits already
             *     - `too-many-requests`: too many requests
             */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-link`: there is no arm
             *     - `ending`: the station is shutting down
             */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jog: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "jog": {
                 *         "frame": "linear",
                 *         "axis": "x_plus",
                 *         "speed_percent": 50
                 *       }
                 *     }
                 */
                "application/json": components["schemas"]["HoldJog"];
            };
        };
        responses: {
            /** @description the button is held */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm still moves
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job has the arm
             *     - `detecting`: the arm is finding out its dialect
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `command`: the command is not sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is not allowed
             *     - `invalid`: a field is not as it has to be
             */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many`: too much waits already
             *     - `too-many-requests`: too many requests
             */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-link`: there is no arm
             *     - `ending`: the station is shutting down
             */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jog_release: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /** @example {} */
                "application/json": components["schemas"]["Nothing"];
            };
        };
        responses: {
            /** @description the button is released */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_stop: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /**
                 * @example {
                 *       "reason": "a hand is in the way"
                 *     }
                 */
                "application/json": components["schemas"]["NewStop"];
            };
        };
        responses: {
            /** @description the stopping packet is on its way */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `lease-gone`: the lease token is not valid any more */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `out-of-range`: a number is not allowed
             *     - `invalid`: a field is not as it has to be
             */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-link`: there is no arm
             *     - `ending`: the station is shutting down
             */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_stop: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /** @example {} */
                "application/json": components["schemas"]["Nothing"];
            };
        };
        responses: {
            /** @description the arm may move */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `still-moving`: the arm still moves
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-link`: there is no arm
             *     - `ending`: the station is shutting down
             */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_lease: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /**
                 * @example {
                 *       "name": "my script"
                 *     }
                 */
                "application/json": components["schemas"]["LeaseRequest"];
            };
        };
        responses: {
            /** @description control */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Granted"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many-clients`: too many clients
             *     - `too-many-requests`: too many requests
             */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_lease: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /** @example {} */
                "application/json": components["schemas"]["Nothing"];
            };
        };
        responses: {
            /** @description control is free */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_lease_ask: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /**
                 * @example {
                 *       "name": "my script"
                 *     }
                 */
                "application/json": components["schemas"]["LeaseRequest"];
            };
        };
        responses: {
            /** @description a lease token, for when control is granted */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Granted"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `lease-gone`: the lease token is not valid any more */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many-clients`: too many clients
             *     - `too-many-requests`: too many requests
             */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_lease_grant: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "to": 3
                 *     }
                 */
                "application/json": components["schemas"]["HandOver"];
            };
        };
        responses: {
            /** @description who has control now */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `not-asking`: nobody asks for control
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_lease_seize: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /**
                 * @example {
                 *       "name": "my script"
                 *     }
                 */
                "application/json": components["schemas"]["LeaseRequest"];
            };
        };
        responses: {
            /** @description control */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Granted"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `lease-gone`: the lease token is not valid any more */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many-clients`: too many clients
             *     - `too-many-requests`: too many requests
             */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_laser: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "for_s": 600
                 *     }
                 */
                "application/json": components["schemas"]["ArmLaser"];
            };
        };
        responses: {
            /** @description the laser is armed */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `stopped`: the arm is stopped
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `out-of-range`: a number is not allowed
             *     - `policy`: the policy does not allow this
             *     - `invalid`: a field is not as it has to be
             */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-link`: there is no arm
             *     - `ending`: the station is shutting down
             */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_laser: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /** @example {} */
                "application/json": components["schemas"]["Nothing"];
            };
        };
        responses: {
            /** @description the laser is disarmed */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-link`: there is no arm
             *     - `ending`: the station is shutting down
             */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_pose_confirm: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /** @example {} */
                "application/json": components["schemas"]["Nothing"];
            };
        };
        responses: {
            /** @description the pose is trusted */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-link`: there is no arm
             *     - `ending`: the station is shutting down
             */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_dialect: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "dialect": "firmware-1.1"
                 *     }
                 */
                "application/json": components["schemas"]["UseDialect"];
            };
        };
        responses: {
            /** @description the dialect is set */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `job-running`: a job has the arm
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_dialect_detect: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /** @example {} */
                "application/json": components["schemas"]["Nothing"];
            };
        };
        responses: {
            /** @description what was found, and by which evidence */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm still moves
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job has the arm
             *     - `detecting`: the arm is finding out its dialect
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `command`: the command is not sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is not allowed
             *     - `dialect-not-found`: the dialect was not found
             *     - `invalid`: a field is not as it has to be
             */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many`: too much waits already
             *     - `too-many-requests`: too many requests
             */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-link`: there is no arm
             *     - `ending`: the station is shutting down
             */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_jobs: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the jobs */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobView"][];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 65536 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "title": "there and back",
                 *       "kind": "program",
                 *       "commands": [
                 *         {
                 *           "type": "move_to",
                 *           "x_mm": 200,
                 *           "y_mm": 0,
                 *           "z_mm": 50,
                 *           "rotation_deg": 0,
                 *           "suction": false,
                 *           "mode": "jump",
                 *           "gripper_deg": 0,
                 *           "pause_s": 0
                 *         }
                 *       ]
                 *     }
                 */
                "application/json": components["schemas"]["NewJob"];
            };
        };
        responses: {
            /** @description the job is queued */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `lease-gone`: the lease token is not valid any more */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `bad-job`: the job cannot be done
             *     - `policy`: the policy does not allow this
             *     - `command`: the command is not sent
             *     - `out-of-range`: a number is not allowed
             *     - `invalid`: a field is not as it has to be
             */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many`: too much waits already
             *     - `too-many-requests`: too many requests
             */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `journal`: the journal cannot be written */
            507: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_jobs_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                id: number;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the job */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobView"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `no-such-job`: there is no such job */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_jobs_id: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path: {
                id: number;
            };
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /** @example {} */
                "application/json": components["schemas"]["Nothing"];
            };
        };
        responses: {
            /** @description the job is over */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `no-such-job`: there is no such job */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `job-phase`: the job does not allow this now
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `journal`: the journal cannot be written */
            507: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_start: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path: {
                id: number;
            };
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /** @example {} */
                "application/json": components["schemas"]["Nothing"];
            };
        };
        responses: {
            /** @description the job runs */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `no-such-job`: there is no such job */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm still moves
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job has the arm
             *     - `detecting`: the arm is finding out its dialect
             *     - `job-phase`: the job does not allow this now
             *     - `cannot-resume`: the job cannot be gone on with
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `command`: the command is not sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is not allowed
             *     - `bad-job`: the job cannot be done
             *     - `invalid`: a field is not as it has to be
             */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many`: too much waits already
             *     - `too-many-requests`: too many requests
             */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-link`: there is no arm
             *     - `ending`: the station is shutting down
             */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `journal`: the journal cannot be written */
            507: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_step: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path: {
                id: number;
            };
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /** @example {} */
                "application/json": components["schemas"]["Nothing"];
            };
        };
        responses: {
            /** @description the step is under way */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `no-such-job`: there is no such job */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm still moves
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job has the arm
             *     - `detecting`: the arm is finding out its dialect
             *     - `job-phase`: the job does not allow this now
             *     - `cannot-resume`: the job cannot be gone on with
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `command`: the command is not sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is not allowed
             *     - `bad-job`: the job cannot be done
             *     - `invalid`: a field is not as it has to be
             */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many`: too much waits already
             *     - `too-many-requests`: too many requests
             */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-link`: there is no arm
             *     - `ending`: the station is shutting down
             */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `journal`: the journal cannot be written */
            507: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_pause: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /** @example {} */
                "application/json": components["schemas"]["Nothing"];
            };
        };
        responses: {
            /** @description the job is paused */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `no-job-runs`: no job is running
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is not as it has to be */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `journal`: the journal cannot be written */
            507: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_jobs_speed: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "percent": 80
                 *     }
                 */
                "application/json": components["schemas"]["Speed"];
            };
        };
        responses: {
            /** @description the job goes at this speed */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `no-job-runs`: no job is running
             *     - `still-moving`: the arm still moves
             *     - `no-vectors`: the job has no vectors
             *     - `cannot-resume`: the job cannot be gone on with
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `out-of-range`: a number is not allowed
             *     - `invalid`: a field is not as it has to be
             */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_jobs_height: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "offset_mm": 0.2
                 *     }
                 */
                "application/json": components["schemas"]["Height"];
            };
        };
        responses: {
            /** @description the job is drawn at this height */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description - `malformed`: the request cannot be understood */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `unauthorised`: this takes a token */
            401: {
                headers: {
                    /** @description How to send a token */
                    "WWW-Authenticate"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `forbidden-host`: the station does not go by this name
             *     - `forbidden-origin`: another site's page may not do this
             *     - `role`: the role does not allow this
             */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `timeout`: the request came too slowly */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `no-lease`: this client does not have control
             *     - `no-job-runs`: no job is running
             *     - `still-moving`: the arm still moves
             *     - `no-vectors`: the job has no vectors
             *     - `cannot-resume`: the job cannot be gone on with
             *     - `lease-gone`: the lease token is not valid any more
             */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-large`: the request is too large */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `media-type`: the body is not JSON */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `out-of-range`: a number is not allowed
             *     - `policy`: the policy does not allow this
             *     - `invalid`: a field is not as it has to be
             */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `too-many-requests`: too many requests */
            429: {
                headers: {
                    /** @description How long to wait, in seconds */
                    "Retry-After"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `ending`: the station is shutting down */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
}
