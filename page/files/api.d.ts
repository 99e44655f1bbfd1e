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
    "/api/v1/arm": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The facts of the arm: its lengths, tools, limits and periods, and what its dialect makes of mouse and gesture packets. They change with the policy and the dialect */
        get: operations["get_arm"];
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
        /** Puts another safety policy in place of the one that holds, and keeps it for the next start; nothing may be under way. With `check` it only looks whether the text is a policy */
        put: operations["put_policy"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/policy/text": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The safety policy as a TOML text, with its comments where it came from a file */
        get: operations["get_policy_text"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/policy/keep-outs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Adds, replaces or removes a keep-out in the text of a draft; the rest keeps its comments and its form, and the policy that holds stays */
        post: operations["post_policy_keep-outs"];
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
    "/healthz": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Whether the station lives, for what starts it again if it does not; the arm may be away */
        get: operations["get_healthz"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/metrics": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The figures of arm, link, queue, laser and job, as Prometheus reads them */
        get: operations["get_metrics"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/events": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** States and notices as server-sent events: `state` and `notice`, each with a message as in `ToClient`. A notice has its number as its id; with `Last-Event-ID` those come first that were missed, as far as the station remembers them. */
        get: operations["get_events"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/packets": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Every packet between the station and the arm, both ways and decoded, from now on, as server-sent events: `packet`, or `lost` with how many came too fast for the one who listens */
        get: operations["get_packets"];
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
    "/api/v1/commands/check": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Says where a command would lead if it were sent now, or why it would be refused; nothing is sent */
        post: operations["post_commands_check"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/arm/near": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Says which limits and keep-outs of the policy an arm at a place would be near to; nothing is sent */
        post: operations["post_arm_near"];
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
    "/api/v1/jog/step": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Moves by one step of a jog button, from where the arm is when all that it was given is over; pump and gripper stay as they are */
        post: operations["post_jog_step"];
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
    "/api/v1/lock": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Keeps the arm for administrators (admin): whoever else has control loses it, and a job that runs is paused */
        post: operations["post_lock"];
        /** Lets everyone take control again (admin) */
        delete: operations["delete_lock"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/slots": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** All time slots that are not over, in their order */
        get: operations["get_slots"];
        /** Says whose the arm is and when, in place of what was said before (admin): while a slot is under way only its student and administrators have control */
        put: operations["put_slots"];
        post?: never;
        /** Ends all time slots (admin): the arm is everyone's */
        delete: operations["delete_slots"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/message": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Tells something to all who watch */
        post: operations["post_message"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/learners": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The students in lessons of whom was told within a minute, by name, with how long each has been at a step */
        get: operations["get_learners"];
        put?: never;
        /** Tells how far a student is in a lesson, for the board of the fleet. It is forgotten after a minute unless it is said again */
        post: operations["post_learners"];
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
    "/api/v1/calibration": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** How the arm differs from the drawing of it, as far as that is known, and what was known before */
        get: operations["get_calibration"];
        /** Says how the arm differs from the drawing of it: from then on all places are true ones. It is kept for this arm, and what was known before is kept beside it; `null` takes the arm to be as drawn (admin) */
        put: operations["put_calibration"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/calibration/angles": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Tells a calibrated arm its true joint angles (state 9, mode 3), which corrects its zeros until its next reset. It has to rest, with its base straight ahead */
        post: operations["post_calibration_angles"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/calibration/fit": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** What touches of the sheet tell: a calibration, how well it explains them, whether to trust it, and which further point would tell most. Nothing is kept */
        post: operations["post_calibration_fit"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/calibration/paper": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** How the paper lies that the tool has touched at true places: three tell its plane, more how it is bent. Nothing is kept: put it into the calibration */
        post: operations["post_calibration_paper"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/calibration/picture": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** What touches of the sheet tell, as a picture: how far each is from where it should be */
        post: operations["post_calibration_picture"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/calibration/points": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The points of the sheet, in the order in which they are touched */
        get: operations["get_calibration_points"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/calibration/sheet": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The sheet to print, A4 and landscape, at 100 % */
        get: operations["get_calibration_sheet"];
        put?: never;
        post?: never;
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
        /** All jobs: the oldest first, unless queued ones were moved */
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
    "/api/v1/jobs/{id}/path": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The way of a job, once through its commands, as it was planned */
        get: operations["get_jobs_id_path"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/again": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Queues what a job does once more, as a new job that is planned anew */
        post: operations["post_jobs_id_again"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/place": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /** Puts a queued job before another queued one, or behind all of them */
        put: operations["put_jobs_id_place"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/forget": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Forgets a job that is over, or that has not begun */
        post: operations["post_jobs_id_forget"];
        delete?: never;
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
    "/api/v1/jobs/{id}/confirm": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Says that a person has done what a paused job waits for; start it again then */
        post: operations["post_jobs_id_confirm"];
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
    "/api/v1/programs/check": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Looks at a whole program: its steps, how long they take, and all that is wrong with it */
        post: operations["post_programs_check"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/edit": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Changes the text of a program; what is not touched keeps its comments and its form */
        post: operations["post_programs_edit"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/convert": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Turns a file of the vendor's programs (`PlayBackPoints.xml`, `.play`) into the text of a program, or the text into such a file; what the other form cannot carry is told */
        post: operations["post_programs_convert"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Queues a program as a job, unless something is wrong with it */
        post: operations["post_programs_jobs"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/recordings": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The recordings of the station, the oldest first */
        get: operations["get_recordings"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/recordings/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A recording, as an MCAP file; of one that is being written what is there so far */
        get: operations["get_recordings_name"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/recordings/{name}/states": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Where the arm was over a stretch of a recording; of a long one not every status is told */
        get: operations["get_recordings_name_states"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/drawings": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Begins to plan a file or a text as a drawing; the 16 latest are kept */
        post: operations["post_drawings"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/drawings/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A drawing, as soon as it is planned, or after a second as far as it is */
        get: operations["get_drawings_id"];
        put?: never;
        post?: never;
        /** Forgets a drawing; a plan under way is given up */
        delete: operations["delete_drawings_id"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/drawings/{id}/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Queues a planned drawing as a job, or the way around it with the laser off */
        post: operations["post_drawings_id_jobs"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/materials": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The pens and materials that a drawing can name */
        get: operations["get_materials"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/formats": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The formats of files that can be drawn */
        get: operations["get_formats"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/tokens": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The tokens of the station, without their secrets; for administrators */
        get: operations["get_tokens"];
        put?: never;
        /** Makes a token, whose secret is shown this once; for administrators */
        post: operations["post_tokens"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/tokens/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** Removes a token: its holder is not known any more; for administrators */
        delete: operations["delete_tokens_name"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/world": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** What is around the station's own virtual arm: tool, paper, ink, objects */
        get: operations["get_world"];
        /** Puts the station's own virtual arm into another world, as it stands */
        put: operations["put_world"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/faults": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** What goes wrong with the station's own virtual arm */
        get: operations["get_faults"];
        /** Lets other things go wrong with the station's own virtual arm from now on, and nothing else any more */
        put: operations["put_faults"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** All stations of the fleet that have been seen */
        get: operations["get_fleet"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet/events": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The stations of the fleet as server-sent events: `member`, each with a message as in `Member`; first all of them, then each one that changes, ten times in a second at the most; and `gone` with the number of one that is not kept in mind any more, as in `{"id": "..."}`: a virtual arm that was given and has ended, or one that was replaced under its name */
        get: operations["get_fleet_events"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet/stop": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Stops the arms of several stations, of all where nothing else is said; anyone may. The answer tells which did not answer: their own pages stop them. A stop of all is kept by every station, and holds for those that come or come back, until a person resets it */
        post: operations["post_fleet_stop"];
        /** Lets the whole fleet move again after a stop of all; an arm that was stopped by itself too stays stopped. A station that is away learns of it when it comes back. For one arm alone: `DELETE /api/v1/stop` of its station */
        delete: operations["delete_fleet_stop"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet/requests": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Asks several stations for the same: method, path and body are those of their own API. The token of this request goes with it, and each station looks by itself what its holder may do */
        post: operations["post_fleet_requests"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet/work": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** All work that was submitted to this station for any arm, in the order in which it came */
        get: operations["get_fleet_work"];
        put?: never;
        /** Submits a drawing or a job to any arm of the fleet that has what it needs: one that is free does it, once */
        post: operations["post_fleet_work"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet/work/{work}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** Cancels work: the station that has it lets it be, unless its arm is at it */
        delete: operations["delete_fleet_work_work"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet/work/{work}/give": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Gives work that is in doubt or has failed to another arm. This is for a person who has looked at the first one: what was drawn there may be drawn again */
        post: operations["post_fleet_work_work_give"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet/offers": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Takes work of the fleet under a key, if no other job is queued or under way here. What is answered under a key is the answer for good: the same request gets the same job, and what was refused is never done */
        post: operations["post_fleet_offers"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet/offers/{key}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** What has become of work that was offered under a key */
        get: operations["get_fleet_offers_key"];
        put?: never;
        post?: never;
        /** Takes an offer back: it is refused whenever it comes, and a job that has come of it ends if it has not begun */
        delete: operations["delete_fleet_offers_key"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet/virtual-arms": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The virtual arms that this station gives to those without an arm */
        get: operations["get_fleet_virtual-arms"];
        put?: never;
        /** Gives a virtual arm: a station of the fleet with a page of its own, which accepts the tokens of this one. Whoever asks for the same name again gets the same arm, with its jobs and recordings */
        post: operations["post_fleet_virtual-arms"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fleet/virtual-arms/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** Ends a virtual arm; its jobs and recordings stay for the next one of its name */
        delete: operations["delete_fleet_virtual-arms_name"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/mcp": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** What the server tells an agent of itself, as server-sent events */
        get: operations["get_mcp"];
        put?: never;
        /** A message of an agent (Model Context Protocol, streamable HTTP): each tool acts with the token that comes with it. One who ends the connection before the answer has given up what was asked for, and the arm is stopped where it was moved for that. */
        post: operations["post_mcp"];
        /** Ends the session of an agent */
        delete: operations["delete_mcp"];
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
            /** @description The calibration by which places are told, if the arm has one. */
            calibrated?: components["schemas"]["CalibratedView"] | null;
            /** @description The dialect that the arm speaks, if that is known. */
            dialect?: components["schemas"]["Dialect"] | null;
            /** @description Whether the pose can be trusted. */
            trust: components["schemas"]["TrustView"];
            /** @description What the arm has still to do. */
            queue: components["schemas"]["QueueView"];
            /** @description Who has control, if anybody has. */
            lease?: components["schemas"]["LeaseView"] | null;
            /** @description The lock that holds the arm for administrators, if one does. */
            lock?: components["schemas"]["LockView"] | null;
            /** @description Whose time it is now and next, where the arm has time slots. */
            slots?: components["schemas"]["SlotsView"] | null;
            /** @description The stop that holds the arm, if one does. */
            stop?: components["schemas"]["StopView"] | null;
            /**
             * @description The stops of the whole fleet that the station knows of, at most one of each station that made one. Those that were
             *     reset are kept too, for stations that come back and do not know it yet.
             */
            fleet_stops?: components["schemas"]["FleetWideStop"][];
            /** @description The laser's interlock. */
            laser: components["schemas"]["LaserView"];
            /** @description The job that runs or is paused. */
            job?: components["schemas"]["JobView"] | null;
            /** @description What is missing of the kept jobs and what to do, if the file in which they are kept was damaged. */
            jobs_missing?: string | null;
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
            /** @description What a calibrated arm says itself. */
            told?: components["schemas"]["Status"] | null;
            /** @description Whether it moves. */
            moving: boolean;
            /** @description The limits and keep-outs of the policy that it is near to. */
            near?: components["schemas"]["NearView"];
        };
        /** @description Where the arm is (Table 2.3); each one received permits one command (note N20). */
        Status: {
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
        };
        /**
         * @description The limits and keep-outs of the policy that a place of the arm is near to.
         *
         *     The closeness of each is above 0, which is 20 mm or 5 degrees off, and 1 at the bound or beyond it.
         */
        NearView: {
            /** @description The bounds of joints and workspace. */
            limits?: components["schemas"]["NearLimit"][];
            /** @description The closeness of the tool to keep-outs, by their names. */
            keep_outs?: {
                [key: string]: number;
            };
        };
        /** @description A bound that the arm is near to. */
        NearLimit: {
            /** @description The quantity that is bounded. */
            quantity: components["schemas"]["BoundedQuantity"];
            /**
             * Format: double
             * @description The bound, in degrees or mm.
             */
            bound: number;
            /**
             * Format: double
             * @description How near it is: above 0, and 1 at the bound or beyond it.
             */
            closeness: number;
        };
        /** @description A quantity that the policy bounds. */
        BoundedQuantity: "base" | "rear" | "fore" | "servo" | "opening" | "x" | "y" | "z" | "reach";
        /** @description By which calibration places are told. */
        CalibratedView: {
            /**
             * @description Whether the arm was told its true angles (state 9, mode 3) since it was switched on: then only its tool
             *     is elsewhere than it says.
             */
            zeros_told: boolean;
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
             * @description By which name time slots know the holder: that of its token where this is one person's.
             * @default
             */
            person: string;
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
        /** @description A lock: only an administrator gets control of the arm. */
        LockView: {
            /** @description Who locked it. */
            by: string;
            /** @description Why, for those who want to move the arm. */
            message?: string | null;
            /**
             * Format: double
             * @description When, in seconds since the station started.
             */
            at_s: number;
        };
        /** @description The time slots of an arm, as far as those who watch have to know: `GET /api/v1/slots` tells all. */
        SlotsView: {
            /** @description The one that is under way, if one is: only its student and administrators have control meanwhile. */
            now?: components["schemas"]["SlotView"] | null;
            /** @description The one that comes next, if one does. */
            next?: components["schemas"]["SlotView"] | null;
            /**
             * Format: double
             * @description When the arm is everyone's again, in seconds since the station started: the end of the last of the slots that follow each
             *     other without a break. Absent where it is everyone's now.
             */
            free_s?: number | null;
        };
        /** @description A time slot, for those who watch. */
        SlotView: {
            /** @description Whose it is. */
            student: string;
            /** @description The group of that one. */
            group?: string | null;
            /**
             * Format: double
             * @description When it begins, in seconds since the station started.
             */
            starts_s: number;
            /**
             * Format: double
             * @description When it ends, in seconds since the station started.
             */
            ends_s: number;
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
            /**
             * @description Whether the packets that stop it have left this computer: if not, it has to be switched off by hand.
             * @default true
             */
            delivered: boolean;
            /**
             * @description Whether it is a stop of the whole fleet.
             * @default false
             */
            of_fleet: boolean;
        };
        /**
         * @description A stop of a whole fleet, or its reset. Every station keeps it and sends it to the others.
         *
         *     Of two with the same origin the one with the higher count is newer. The origin alone counts, so neither the clocks of
         *     other stations nor the order of messages matter. Stops of two origins hold beside each other.
         */
        FleetWideStop: {
            /** @description The number of the station that made it, as in [`Member::id`]. */
            origin: string;
            /**
             * Format: uint64
             * @description Its number among the stops of that station: at least the time when it was made, in milliseconds since
             *     1970-01-01T00:00:00Z by the clock of that station, and always above the one before.
             */
            count: number;
            /** @description Who stopped the fleet. */
            by: string;
            /** @description Why. */
            reason?: string | null;
            /** @description Who reset it for the whole fleet; absent while it holds. */
            reset_by?: string | null;
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
            /**
             * Format: int64
             * @description When it was queued, in milliseconds since 1970-01-01T00:00:00Z.
             */
            created_ms: number;
            /** @description How far it is. */
            phase: components["schemas"]["JobPhase"];
            /** @description Why it is paused, stopped or failed. */
            reason?: string | null;
            /**
             * @description Whether it is paused where a person has to do something, such as change the pen: it goes on only after
             *     [`Request::ConfirmJob`](crate::Request::ConfirmJob).
             * @default false
             */
            waits_for_person: boolean;
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
        /** @description The facts of the arm: they hold until the policy or the dialect changes. */
        ArmFacts: {
            /** @description The lengths of its links and rods. */
            dimensions: components["schemas"]["Dimensions"];
            /** @description The tools that were sold with it. */
            tools: components["schemas"]["ToolFacts"][];
            /** @description How far its joints may turn, by the policy that holds. */
            joints: components["schemas"]["JointLimits"];
            /** @description Where its tool may be, by the policy that holds. */
            workspace: components["schemas"]["Workspace"];
            /**
             * Format: double
             * @description From one status to the next while there is room in its queue, in seconds; over Bluetooth they come sooner.
             */
            status_period_s: number;
            /**
             * Format: double
             * @description From one tick of its controller to the next, in seconds.
             */
            tick_s: number;
            /**
             * Format: double
             * @description From a packet to the next one that must not get lost, in seconds.
             */
            packet_gap_s: number;
            /** @description What mouse and gesture packets mean to it; none while nobody knows its dialect. */
            dialect?: components["schemas"]["DialectFacts"] | null;
        };
        /** @description The lengths of the arm that it takes to draw it, in mm. X is forward in the plane of the arm, and Z up. */
        Dimensions: {
            /**
             * Format: double
             * @description From the pivot of the rear arm to the elbow.
             */
            rear_arm_mm: number;
            /**
             * Format: double
             * @description From the elbow to the wrist.
             */
            forearm_mm: number;
            /**
             * Format: double
             * @description From the pivot of the crank to its end, and from the elbow to the tail of the forearm.
             */
            crank_mm: number;
            /** @description From the pivot of the rear arm to where the rear rod is held, and from the elbow to the same: X and Z. */
            rear_rod_at_mm: number[];
            /** @description From the elbow to where the front rod is held, and from the wrist to the same: X and Z. */
            front_rod_at_mm: number[];
            /**
             * Format: double
             * @description How high the pivot of the rear arm is above what the arm stands on (Figure 3.1).
             */
            pivot_above_table_mm: number;
        };
        /** @description A tool. */
        ToolFacts: {
            /** @description What it is. */
            kind: components["schemas"]["Tool"];
            /**
             * Format: double
             * @description From the wrist to the axis of the tool, level, in mm.
             */
            reach_mm: number;
            /**
             * Format: double
             * @description From the height of the wrist down to the tip, by the policy that holds, in mm.
             */
            length_mm: number;
            /** @description What an arm with this tool makes of gesture packets (note N18); none while nobody knows its dialect. */
            gesture?: components["schemas"]["GestureFacts"] | null;
        };
        /** @description What is mounted at the end of the arm. */
        Tool: "suction_cup" | "gripper" | "pen" | "laser";
        /** @description The units of a gesture packet. */
        GestureFacts: {
            /** @description Along X. */
            x: components["schemas"]["GestureAxis"];
            /** @description Along Y. */
            y: components["schemas"]["GestureAxis"];
            /** @description Along Z. */
            z: components["schemas"]["GestureAxis"];
        };
        /** @description One axis of a gesture packet: its number is (place in mm - `zero_mm`) times `units_per_mm`. */
        GestureAxis: {
            /**
             * Format: double
             * @description The place that the number 0 means, in mm.
             */
            zero_mm: number;
            /**
             * Format: double
             * @description What is counted for each mm beyond that.
             */
            units_per_mm: number;
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
        /** @description What the dialect of the arm means for one who leads it by hand. */
        DialectFacts: {
            /** @description The dialect. */
            name: components["schemas"]["Dialect"];
            /**
             * @description Whether Y of a mouse packet swings the base, to the right where it is positive, and its rotation is the angle of the
             *     servo (note N9).
             */
            mouse_swings: boolean;
            /**
             * Format: uint
             * @description How often the same gesture packet has to be sent until the arm is where the hand is (note N49).
             */
            gesture_samples: number;
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
            type: "policy_changed";
        } | {
            /** @constant */
            type: "calibrated";
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
            type: "locked";
        } | {
            /** @constant */
            type: "unlocked";
        } | {
            /** @constant */
            type: "slots_changed";
        } | {
            /** @constant */
            type: "slot_began";
            /** @description Who. */
            student: string;
        } | {
            /** @constant */
            type: "slot_ending";
            /** @description Who. */
            student: string;
        } | {
            /** @constant */
            type: "slot_ended";
            /** @description Who. */
            student: string;
        } | {
            /** @constant */
            type: "message";
            /** @description Who. */
            client: components["schemas"]["ClientId"];
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
             *       "z_mm": -103,
             *       "below_paper_mm": 5
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
             *       "longest_s": 3600,
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
             *       "ahead_s": 0.5,
             *       "line_s": 3600
             *     }
             */
            queue: components["schemas"]["QueueRules"];
        };
        /** @description The table, which no tool tip may go into. */
        Table: {
            /**
             * Format: double
             * @description The height of its surface in the base frame, in mm: -300 to 136.
             * @default -103
             */
            z_mm: number;
            /**
             * Format: double
             * @description How far below the paper a tool tip may be where a calibration knows how the paper lies, in mm: 0 to 300.
             * @default 5
             */
            below_paper_mm: number;
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
             * Format: double
             * @description How long a vector may burn, in s: 0.1 to 3600. The arm finishes what it has received, so it burns on for so
             *     long after a stop.
             * @default 3600
             */
            longest_s: number;
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
            /**
             * Format: double
             * @description How long a straight line (MOVL) of a client may take, in s: 0.5 to 3600. A longer one is sent in pieces, between which
             *     the arm stands for a moment; after a stop it finishes the piece that it is at.
             * @default 3600
             */
            line_s: number;
        };
        /** @description A text that is to be the policy. */
        PolicyText: {
            /** @description The TOML text, as `dobot policy` shows one. */
            text: string;
            /**
             * @description Only look whether it is one.
             * @default false
             */
            check: boolean;
        };
        /** @description A change of a keep-out in a draft of a policy. */
        EditPolicy: {
            /** @description The TOML text of the draft. */
            text: string;
            /** @description The change. */
            edit: components["schemas"]["KeepOutEdit"];
        };
        /** @description A change of a keep-out in the text of a policy. */
        KeepOutEdit: {
            /** @constant */
            type: "add";
            /** @description The new keep-out. */
            keep_out: components["schemas"]["KeepOut"];
        } | {
            /** @constant */
            type: "replace";
            /** @description The name of the old one, which stays. */
            name: string;
            /** @description The new one. */
            keep_out: components["schemas"]["KeepOut"];
        } | {
            /** @constant */
            type: "remove";
            /** @description Its name. */
            name: string;
        };
        /** @description A draft of a policy. */
        PolicyDraft: {
            /** @description Its TOML text. */
            text: string;
        };
        /** @description One event, as its lines say it; for the document only. */
        ServerSentEvent: {
            /** @description What it tells: `state` or `notice`; `packet` or `lost`; `member` or `gone`. */
            event: string;
            /** @description The number of a notice; nothing else has one. */
            id?: string | null;
            /** @description A message as in `ToClient`, a packet as in `PacketView`, or a station of the fleet as in `Member`, as text. */
            data: string;
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
            tool: components["schemas"]["Tool"];
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
            type: "way";
            /** @description The way. */
            way: components["schemas"]["WayView"];
        } | {
            /** @constant */
            type: "near";
            /** @description The limits and keep-outs. */
            near: components["schemas"]["NearView"];
        } | {
            /** @constant */
            type: "stopping";
            /**
             * Format: double
             * @description By when the arm is at rest at the latest, in seconds; without a meaning where nothing was delivered.
             */
            rests_within_s: number;
            /**
             * @description Whether a link takes the packets. If not, they are sent as soon as there is one: the arm has to be switched
             *     off by hand.
             */
            delivered: boolean;
        } | {
            /** @constant */
            type: "lease";
            /** @description Who has it, if anybody has. */
            lease?: components["schemas"]["LeaseView"] | null;
        } | {
            /** @constant */
            type: "slots";
            /** @description The slots. */
            slots: components["schemas"]["TimeSlot"][];
        } | {
            /** @constant */
            type: "job";
            /** @description The job. */
            job: components["schemas"]["JobView"];
        } | {
            /** @constant */
            type: "calibrated";
            /** @description Both. */
            calibrations: components["schemas"]["Calibrations"];
        } | {
            /** @constant */
            type: "found";
            /** @description What was found, and by which evidence. */
            finding: components["schemas"]["Finding"];
        };
        /** @description Where a command would lead if it were sent now, behind all that waits: it is allowed. */
        WayView: {
            /**
             * Format: double
             * @description How long motion and pause take, in seconds; nothing for a button, which goes on until it is released.
             */
            takes_s?: number | null;
            /**
             * @description The places of the tool on its way, its beginning and its end among them, at equal distances in time: x, y and z
             *     in millimetres.
             */
            path_mm: number[][];
            /** @description Base, rear arm, forearm and servo at the end, in degrees. */
            joints_deg: number[];
        };
        /** @description A time slot, told from now on: no clocks are compared, so that a wrong one does no harm. */
        TimeSlot: {
            /** @description Whose it is: 1 to 60 visible characters. Capital letters and spaces around it make no difference. */
            student: string;
            /** @description The group of that one: 1 to 40 small letters of English, digits and hyphens. */
            group?: string | null;
            /**
             * Format: double
             * @description When it begins, in seconds from now; 0 where it has begun.
             */
            starts_in_s: number;
            /**
             * Format: double
             * @description When it ends, in seconds from now: at least a second after it begins.
             */
            ends_in_s: number;
        };
        /** @description What is known of how an arm differs from the drawing of it. */
        Calibrations: {
            /** @description What holds; nothing for an arm that is taken to be as drawn. */
            calibration?: components["schemas"]["CalibrationFile"] | null;
            /** @description What held before, to bring it back. */
            before?: components["schemas"]["CalibrationFile"] | null;
        };
        /** @description What is kept of an arm. */
        CalibrationFile: {
            /** @description What people call the arm, at most 64 characters. */
            name?: string | null;
            /** @description How much further each joint stands than the arm says, in degrees. */
            zeros: components["schemas"]["Zeros"];
            /**
             * @description Where the tool is, compared with the drawing of the arm.
             * @default {
             *       "out_mm": 0,
             *       "left_mm": 0
             *     }
             */
            tool: components["schemas"]["ToolOffset"];
            /**
             * @description Where the base's axis stands in the sheet's frame, in mm.
             * @default {
             *       "x_mm": 0,
             *       "y_mm": 0
             *     }
             */
            axis: components["schemas"]["Axis"];
            /**
             * @description Where the paper lies.
             * @default null
             */
            paper: components["schemas"]["PaperPlane"] | null;
            /**
             * @description How slack each joint is, in degrees.
             * @default {
             *       "base": 0,
             *       "rear": 0,
             *       "fore": 0
             *     }
             */
            backlash: components["schemas"]["Backlash"];
            /**
             * @description How well the touches agreed.
             * @default null
             */
            touched: components["schemas"]["Touched"] | null;
        };
        /** @description How much further each joint stands than the arm says. */
        Zeros: {
            /**
             * Format: double
             * @description The base, in degrees.
             */
            base: number;
            /**
             * Format: double
             * @description The rear arm, in degrees.
             */
            rear: number;
            /**
             * Format: double
             * @description The forearm, in degrees.
             */
            fore: number;
        };
        /** @description Where the tool is, compared with the drawing of the arm. */
        ToolOffset: {
            /**
             * Format: double
             * @description Further out, in mm.
             */
            out_mm: number;
            /**
             * Format: double
             * @description To the left, in mm.
             */
            left_mm: number;
        };
        /** @description Where the base's axis stands in the sheet's frame. */
        Axis: {
            /**
             * Format: double
             * @description Forward, in mm.
             */
            x_mm: number;
            /**
             * Format: double
             * @description To the left, in mm.
             */
            y_mm: number;
        };
        /**
         * @description Where the paper lies, as Z of the wrist where the tool touches it: a plane, and what it rises above the plane at the
         *     places that were touched.
         */
        PaperPlane: {
            /**
             * Format: double
             * @description The height below the base's axis, in mm.
             */
            z_mm: number;
            /**
             * Format: double
             * @description How much it rises for each mm forward.
             */
            slope_x: number;
            /**
             * Format: double
             * @description How much it rises for each mm to the left.
             */
            slope_y: number;
            /**
             * @description Places that were touched, in mm: forward, to the left, and how much higher than the plane the paper is there.
             *     Between them it is bent evenly; without any it is flat.
             */
            heights?: number[][];
        };
        /** @description How far a motor turns in vain where its joint turns back. */
        Backlash: {
            /**
             * Format: double
             * @description The base, in degrees.
             */
            base: number;
            /**
             * Format: double
             * @description The rear arm, in degrees.
             */
            rear: number;
            /**
             * Format: double
             * @description The forearm, in degrees.
             */
            fore: number;
        };
        /** @description How well the touches agreed. */
        Touched: {
            /**
             * Format: uint
             * @description How many counted.
             */
            points: number;
            /**
             * Format: double
             * @description Their typical residual, in mm.
             */
            typical_mm: number;
            /**
             * Format: double
             * @description Their largest residual, in mm.
             */
            largest_mm: number;
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
        /** @description A command to be looked at. */
        CheckCommand: {
            /** @description The command. */
            command: components["schemas"]["Command"];
        };
        /** @description A place of the tool. */
        Place: {
            /**
             * Format: double
             * @description Forward of the axis of the base, in mm.
             */
            x_mm: number;
            /**
             * Format: double
             * @description To the left of it, in mm.
             */
            y_mm: number;
            /**
             * Format: double
             * @description The height of the wrist, in mm.
             */
            z_mm: number;
            /**
             * Format: double
             * @description The rotation of the tool, in degrees.
             */
            rotation_deg: number;
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
        /** @description A step. */
        NewStep: {
            /** @description The button. */
            button: components["schemas"]["Button"];
            /**
             * Format: float
             * @description How far, in mm or degrees.
             */
            by: number;
        };
        /** @description A button of joint jog or of linear jog (Table 2.5; note N14). */
        Button: {
            /** @constant */
            frame: "joint";
            axis: components["schemas"]["JointJogAxis"];
        } | {
            /** @constant */
            frame: "linear";
            axis: components["schemas"]["LinearJogAxis"];
        };
        /** @description A stop. */
        NewStop: {
            /**
             * @description Why, for those who find the arm stopped.
             * @default null
             */
            reason: string | null;
            /**
             * @description The stop of the whole fleet that this is part of; only other stations of the fleet say so.
             * @default null
             */
            fleet: components["schemas"]["FleetWideStop"] | null;
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
        /** @description Why the arm is locked. */
        NewLock: {
            /**
             * @description For those who want to move the arm. What is longer than 200 characters is cut.
             * @default null
             */
            message: string | null;
        };
        /** @description Whose the arm is, and when. */
        NewSlots: {
            /** @description The slots, in any order: up to 200, none of which overlaps another one. */
            slots: components["schemas"]["TimeSlot"][];
        };
        /** @description What to tell. */
        NewMessage: {
            /** @description The text. What is longer than 200 characters is cut. */
            text: string;
        };
        /** @description A student in a lesson. */
        LearnerView: {
            /** @description What the student is called. */
            student: string;
            /** @description The name of the lesson's file. */
            lesson: string;
            /**
             * Format: uint32
             * @description How many of its steps are done: all of them once it is finished.
             */
            done: number;
            /**
             * Format: uint32
             * @description How many steps it has.
             */
            steps: number;
            /**
             * Format: double
             * @description For how long the student has been at this step, in seconds.
             */
            for_s: number;
        };
        /** @description How far a student is in a lesson. */
        Progress: {
            /** @description What the student is called: 1 to 60 visible characters. */
            student: string;
            /** @description The name of the lesson's file, as in `tour`: 1 to 40 small letters of English, digits and underscores. */
            lesson: string;
            /**
             * Format: uint32
             * @description How many of its steps are done: all of them once it is finished.
             */
            done: number;
            /**
             * Format: uint32
             * @description How many steps it has, from 1 to 1000.
             */
            steps: number;
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
        /** @description What is to be known of the arm. */
        NewCalibration: {
            /** @description The calibration; `null` for an arm as drawn. */
            calibration?: components["schemas"]["CalibrationFile"] | null;
        };
        /** @description Points that the tool has touched. */
        NewTouches: {
            /** @description What the arm said at each, in the order in which they were touched. */
            touches: components["schemas"]["TouchedPoint"][];
            /**
             * Format: double
             * @description How long the bar of the print is, measured with a ruler, in mm; one that is scaled is refused.
             * @default null
             */
            bar_mm: number | null;
            /**
             * @description Whether the laser is mounted, and no suction cup.
             * @default false
             */
            laser: boolean;
            /**
             * @description How slack the joints are known to be.
             * @default {
             *       "base": 0,
             *       "rear": 0,
             *       "fore": 0
             *     }
             */
            backlash: components["schemas"]["Backlash"];
        };
        /** @description A known point, and what the arm said when its tool touched it. */
        TouchedPoint: {
            /** @description Where it is on the sheet: forward and to the left, in mm. */
            place_mm: number[];
            /**
             * Format: double
             * @description How high above the paper it is, in mm.
             * @default 0
             */
            height_mm: number;
            /**
             * @description The angles that the arm says of base, rear arm and forearm, in degrees: `told` of its state where it is
             *     calibrated already.
             */
            told_deg: number[];
        };
        /** @description What touches tell. */
        FitReport: {
            /** @description How the arm differs from the drawing of it. */
            calibration: components["schemas"]["CalibrationFile"];
            /** @description How far each touch is from where it should be, in mm. */
            away_mm: number[];
            /**
             * Format: uint
             * @description The touch that was left out because it contradicts all others, counted from 0.
             */
            left_out?: number | null;
            /**
             * Format: double
             * @description How wrong a place on the sheet may still be, typically, in mm.
             */
            expected_mm: number;
            /** @description What these points tell badly. */
            unsure: components["schemas"]["Unsure"][];
            /** @description Which further point would tell most. */
            advice?: components["schemas"]["Advice"] | null;
            /**
             * @description Whether to use it: `good`; `unchecked`, where so few points were touched that a wrong one would not be
             *     noticed; or `doubtful`.
             */
            trust: components["schemas"]["Trust"];
        };
        /** @description A number that the touches tell badly. */
        Unsure: {
            /** @description What of the arm. */
            what: string;
            /**
             * Format: double
             * @description Its deviation.
             */
            by: number;
            /** @description The unit of the deviation. */
            unit: string;
        };
        /** @description A point that is worth touching. */
        Advice: {
            /** @description Where it is on the sheet, in mm. */
            place_mm: number[];
            /**
             * Format: double
             * @description How high above the paper, in mm.
             */
            height_mm: number;
            /**
             * Format: double
             * @description The share of the doubt that goes away with it, from 0 to 1.
             */
            gain: number;
        };
        /** @description Whether to use a calibration. */
        Trust: "good" | "unchecked" | "doubtful";
        /** @description Places of the paper that the tool has touched. */
        PaperTouches: {
            /** @description Where the arm stood at each: forward, to the left and up, in mm, true places as its state has them. */
            places_mm: number[][];
        };
        /** @description How the paper lies. */
        PaperReport: {
            /** @description What is to be kept of it. */
            paper: components["schemas"]["PaperPlane"];
            /** @description How much higher than the plane each touch is, in mm. */
            away_mm: number[];
            /**
             * Format: double
             * @description How steep the plane is, in degrees.
             */
            slope_deg: number;
        };
        /** @description The points of the sheet. */
        SheetPoints: {
            /** @description Forward and to the left of the base's axis, in mm. */
            points_mm: number[][];
            /**
             * Format: double
             * @description How long the bar is where the print is true, in mm.
             */
            bar_mm: number;
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
        /** @description The way of a job, once through its commands, as it was planned. */
        JobPath: {
            /**
             * @description Places of the tool, one after the other: x, y and z in millimetres of each. Between two of them the tool goes
             *     straight, or as near to straight as can be seen.
             */
            path_mm: number[][];
            /** @description To which command each place belongs, from 0; the last place of a command is its end. */
            commands: number[];
            /** @description Whether the way to each place is drawn or burnt: the laser is on, or the pen is down. */
            marks: boolean[];
            /** @description When each place is reached, in seconds since the job began, pauses of the arm included. */
            until_s: number[];
        };
        /** @description Where a queued job stands in the list. */
        Place2: {
            /**
             * Format: uint64
             * @description The number of the queued job that comes behind it; without it the job comes last.
             * @default null
             */
            before: number | null;
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
        /** @description A program, with the files that it names. */
        ProgramText: {
            /** @description Its TOML text. */
            text: string;
            /**
             * @description The texts of the programs that it calls and of its drawings, by their names in it.
             * @default {}
             */
            files: {
                [key: string]: string;
            };
        };
        /** @description What a program does, and what is wrong with it. */
        ProgramReport: {
            /** @description What a person calls it. */
            title: string;
            /** @description Its steps, in the order in which they are done; those of a repeat at its end stand here once. */
            steps: components["schemas"]["StepReport"][];
            /** @description All that is wrong, in the order of the steps. Of a text that is no program only the first thing. */
            problems: components["schemas"]["ProgramProblem"][];
            /**
             * Format: double
             * @description How long all of it takes once, in seconds, by the motion model.
             */
            once_s: number;
            /**
             * Format: double
             * @description How long a cycle takes that follows another one, in seconds; none where nothing is done again.
             */
            cycle_s?: number | null;
            /**
             * Format: double
             * @description How long all of it takes, in seconds; none where it goes on until a person ends it.
             */
            total_s?: number | null;
        };
        /** @description A step of a program. */
        StepReport: {
            /** @description What it does. */
            label: string;
            /** @description The called program in which it stands; none in the program itself. */
            file?: string | null;
            /**
             * Format: uint
             * @description The line on which it begins, counted from 1.
             */
            line: number;
            /**
             * Format: uint
             * @description Its first command in the job, counted from 0.
             */
            first: number;
            /**
             * Format: double
             * @description How long it takes the first time, in seconds.
             */
            takes_s: number;
        };
        /** @description Something that is wrong with a program. */
        ProgramProblem: {
            /**
             * Format: uint
             * @description The step, counted from 1 in the order in which they are done; none where the text is no program.
             */
            step?: number | null;
            /** @description The called program in which it stands; none in the program itself. */
            file?: string | null;
            /**
             * Format: uint
             * @description The line, counted from 1, where it is known.
             */
            line?: number | null;
            /** @description What is wrong, and what is allowed. */
            message: string;
            /** @description What helps. */
            remedy?: string | null;
        };
        /** @description Changes of a program's text. */
        EditProgram: {
            /**
             * @description The text; where it is empty, a program begins.
             * @default
             */
            text: string;
            /** @description What is changed, in order; either all of it is or nothing. */
            edits: components["schemas"]["Edit"][];
        };
        /**
         * @description A change of a program's text; what is not touched keeps its comments and its form. Steps are those of the program
         *     itself, counted from 0.
         */
        Edit: {
            /** @constant */
            type: "insert";
            /**
             * Format: uint
             * @description Where.
             */
            at: number;
            /** @description The step. */
            step: components["schemas"]["Action"];
        } | {
            /** @constant */
            type: "insert_path";
            /**
             * Format: uint
             * @description Where.
             */
            at: number;
            /** @description Its places, in order. */
            places: components["schemas"]["RecordedPlace"][];
            /**
             * Format: double
             * @description How far the lines may be from the places, in mm.
             */
            tolerance_mm: number;
        } | {
            /** @constant */
            type: "replace";
            /**
             * Format: uint
             * @description Which.
             */
            at: number;
            /** @description The step. */
            step: components["schemas"]["Action"];
        } | {
            /** @constant */
            type: "remove";
            /**
             * Format: uint
             * @description Which.
             */
            at: number;
        } | {
            /** @constant */
            type: "move";
            /**
             * Format: uint
             * @description Which.
             */
            from: number;
            /**
             * Format: uint
             * @description Its number then.
             */
            to: number;
        } | {
            /** @constant */
            type: "set_point";
            /** @description Its name. */
            name: string;
            /** @description Where it is. */
            point: components["schemas"]["Point"];
        };
        /** @description What a step does. */
        Action: {
            /** @description Goes to a place. */
            go?: components["schemas"]["Place3"] | null;
            /** @description The way there: `jump` (as without it), `movl` in a straight line, or `movj` by the joints. */
            path?: components["schemas"]["MovingMode"] | null;
            /** @description So far from the place, in mm along the axes of its frame. */
            offset?: components["schemas"]["Offset"] | null;
            /** @description Whether the pump runs from there on. */
            suction?: boolean | null;
            /**
             * Format: double
             * @description The gripper's angle from there on, -90 to 90 degrees.
             */
            gripper?: number | null;
            /**
             * Format: double
             * @description How long the arm waits there, 0 to 655 seconds.
             */
            pause?: number | null;
            /** @description Switches the laser. */
            laser?: boolean | null;
            /** @description Waits for a person, who is told this, in 1 to 200 letters. */
            wait?: string | null;
            /** @description Waits for the other arms of a program for several, at the barrier of this name, in 1 to 40 letters. */
            barrier?: string | null;
            /** @description Sets speeds. */
            speed?: components["schemas"]["Speed2"] | null;
            /** @description Says which of the named tools is mounted. */
            tool?: string | null;
            /** @description Does `steps` so often, or `"forever"`. */
            repeat?: components["schemas"]["Times"] | null;
            /** @description Does `steps` for each cell of a grid, or of several side by side, by their names. */
            each?: components["schemas"]["Names"] | null;
            /** @description What `repeat` and `each` do. */
            steps?: components["schemas"]["Step"][] | null;
            /** @description Does the steps of another program. */
            call?: string | null;
            /** @description Goes along an arc from here to its end. */
            arc?: components["schemas"]["Arc"] | null;
            /** @description Goes once around a circle from here. */
            circle?: components["schemas"]["Arc"] | null;
            /** @description Draws a file. */
            drawing?: components["schemas"]["Drawing"] | null;
        };
        /** @description A place: the name of a point or of a grid's cell, or a point itself. */
        Place3: string | components["schemas"]["Point"];
        /**
         * @description A point: x, y and z in mm, with a rotation and a frame if wanted; or base, rear and fore in degrees, with the
         *     servo if it is not at 0.
         */
        Point: {
            /**
             * Format: double
             * @description Forward of the base's axis, or along the frame's x axis, in mm.
             */
            x?: number | null;
            /**
             * Format: double
             * @description To the left of it, or along the frame's y axis, in mm.
             */
            y?: number | null;
            /**
             * Format: double
             * @description Above the rear arm's pivot, or along the frame's z axis, in mm.
             */
            z?: number | null;
            /**
             * Format: double
             * @description How the tool is turned from the frame's x axis, counter-clockwise, in degrees; 0 if nothing is said.
             */
            rotation?: number | null;
            /** @description The name of a frame; the base frame if nothing is said. */
            frame?: string | null;
            /**
             * Format: double
             * @description The base's angle in degrees, counter-clockwise seen from above.
             */
            base?: number | null;
            /**
             * Format: double
             * @description The rear arm's angle in degrees from the vertical, forward positive.
             */
            rear?: number | null;
            /**
             * Format: double
             * @description The forearm's angle in degrees below the horizontal.
             */
            fore?: number | null;
            /**
             * Format: double
             * @description The servo's angle in degrees.
             */
            servo?: number | null;
        };
        /** @description A way along the axes of a frame, in mm. */
        Offset: {
            /**
             * Format: double
             * @description Along x.
             */
            x?: number;
            /**
             * Format: double
             * @description Along y.
             */
            y?: number;
            /**
             * Format: double
             * @description Along z.
             */
            z?: number;
        };
        /**
         * @description Speeds of targets (states 9 and 10; Table 3.9); what is not said stays as it was, at first as in an arm that
         *     was just switched on.
         */
        Speed2: {
            /**
             * Format: double
             * @description All speeds of targets, in percent of the ones below, above 0 to 100; 50 at first.
             */
            percent?: number | null;
            /**
             * Format: double
             * @description Their accelerations, in percent, above 0 to 100; 50 at first.
             */
            acceleration_percent?: number | null;
            /**
             * Format: double
             * @description Base, rear arm and forearm, in degrees/s; 200 at first.
             */
            joint?: number | null;
            /**
             * Format: double
             * @description Their acceleration, in degrees/s2; 200 at first.
             */
            joint_acceleration?: number | null;
            /**
             * Format: double
             * @description The servo, in degrees/s; 200 at first.
             */
            servo?: number | null;
            /**
             * Format: double
             * @description Its acceleration, in degrees/s2; 200 at first.
             */
            servo_acceleration?: number | null;
            /**
             * Format: double
             * @description Along a line, in mm/s; 100 at first.
             */
            line?: number | null;
            /**
             * Format: double
             * @description The acceleration along a line, in mm/s2; 200 at first.
             */
            line_acceleration?: number | null;
            /**
             * Format: double
             * @description How high a JUMP lifts, in mm, 0 to 300. An arm that was just switched on lifts by 10 or 20 mm, depending on
             *     its firmware (note N11): once one of the speeds above is set, without this it is 20.
             */
            jump_height?: number | null;
        };
        /** @description How often, or until a person ends it. */
        Times: number | "forever";
        /** @description One name, or several. */
        Names: string | string[];
        /**
         * @description A step. Exactly one of `go`, `laser`, `wait`, `barrier`, `speed`, `tool`, `repeat`, `each`, `call`, `arc`, `circle`
         *     and `drawing` says what it does; or it has only `suction`, `gripper` and `pause`, which act where the arm is.
         */
        Step: {
            /** @description Goes to a place. */
            go?: components["schemas"]["Place3"] | null;
            /** @description The way there: `jump` (as without it), `movl` in a straight line, or `movj` by the joints. */
            path?: components["schemas"]["MovingMode"] | null;
            /** @description So far from the place, in mm along the axes of its frame. */
            offset?: components["schemas"]["Offset"] | null;
            /** @description Whether the pump runs from there on. */
            suction?: boolean | null;
            /**
             * Format: double
             * @description The gripper's angle from there on, -90 to 90 degrees.
             */
            gripper?: number | null;
            /**
             * Format: double
             * @description How long the arm waits there, 0 to 655 seconds.
             */
            pause?: number | null;
            /** @description Switches the laser. */
            laser?: boolean | null;
            /** @description Waits for a person, who is told this, in 1 to 200 letters. */
            wait?: string | null;
            /** @description Waits for the other arms of a program for several, at the barrier of this name, in 1 to 40 letters. */
            barrier?: string | null;
            /** @description Sets speeds. */
            speed?: components["schemas"]["Speed2"] | null;
            /** @description Says which of the named tools is mounted. */
            tool?: string | null;
            /** @description Does `steps` so often, or `"forever"`. */
            repeat?: components["schemas"]["Times"] | null;
            /** @description Does `steps` for each cell of a grid, or of several side by side, by their names. */
            each?: components["schemas"]["Names"] | null;
            /** @description What `repeat` and `each` do. */
            steps?: components["schemas"]["Step"][] | null;
            /** @description Does the steps of another program. */
            call?: string | null;
            /** @description Goes along an arc from here to its end. */
            arc?: components["schemas"]["Arc"] | null;
            /** @description Goes once around a circle from here. */
            circle?: components["schemas"]["Arc"] | null;
            /** @description Draws a file. */
            drawing?: components["schemas"]["Drawing"] | null;
        };
        /**
         * @description An arc or a circle from where the arm is, given by two more places on it. The arm goes along it by straight
         *     lines (MOVL), from rest to rest: a target can be sent again when a packet was lost, a vector cannot.
         */
        Arc: {
            /** @description A place on the way. */
            through: components["schemas"]["Place3"];
            /** @description Where an arc ends; the third place of a circle. */
            to: components["schemas"]["Place3"];
            /**
             * Format: double
             * @description How far the straight lines may be from the arc, 0.01 to 10 mm; 0.5 if nothing is said.
             * @default 0.5
             */
            tolerance: number;
        };
        /** @description A drawing as a step. What reads the program prepares it, as `dobot draw` does. */
        Drawing: {
            /** @description The drawing's file, beside the program. */
            file: string;
            /**
             * Format: double
             * @description The height of the wrist at which the pen touches the paper, in mm.
             */
            pen_down: number;
            /** @description The options of `dobot draw`, under their names in a request: `place`, `tool`, `way`, `what`. */
            options?: {
                [key: string]: unknown;
            };
        };
        /** @description A place of a path: where the tool was, and what it did there. */
        RecordedPlace: {
            /** @description x, y and z, in millimetres in the base frame. */
            point_mm: number[];
            /**
             * Format: double
             * @description The rotation of the tool relative to the base frame, in degrees.
             */
            rotation_deg: number;
            /** @description Whether the pump ran. */
            suction: boolean;
            /**
             * Format: double
             * @description The gripper's angle, in degrees.
             */
            gripper_deg: number;
        };
        /** @description The text of a program. */
        EditedProgram: {
            /** @description The text. */
            text: string;
            /**
             * Format: uint
             * @description How many steps it has.
             */
            steps: number;
        };
        /** @description A program in one form that is wanted in another. */
        ConvertProgram: {
            /**
             * @description Its text; a file of the vendor's programs has bytes instead.
             * @default null
             */
            text: string | null;
            /**
             * @description The bytes of a file, in base64.
             * @default null
             */
            data: string | null;
            /** @description What the bytes are; a text is a program. */
            from?: components["schemas"]["ProgramForm"];
            /** @description What it is to be. */
            to: components["schemas"]["ProgramForm"];
        };
        /** @description A form of programs. */
        ProgramForm: "toml" | "xml" | "play";
        /** @description A program in the form that was asked for. */
        ConvertedProgram: {
            /** @description The text. */
            text: string;
            /** @description What was surprising, and what the form cannot carry. */
            warnings: string[];
        };
        /** @description A program that is to become a job. */
        NewProgram: {
            /** @description The program. */
            program: components["schemas"]["ProgramText"];
            /**
             * Format: uint
             * @description The step with which it begins, counted from 1 in the order in which they are done.
             * @default 1
             */
            from_step: number;
            /** @description How often it is done; without this as often as it says itself. */
            times?: components["schemas"]["Repeat"] | null;
        };
        /** @description How often a program is done. */
        Repeat: {
            /** Format: uint64 */
            count: number;
        } | "forever";
        /** @description A recording. */
        RecordingView: {
            /** @description The name of its file. */
            name: string;
            /**
             * Format: int64
             * @description When it was begun, in milliseconds since 1970-01-01T00:00:00Z.
             */
            begin_ms: number;
            /**
             * Format: uint64
             * @description How long it is, in bytes.
             */
            bytes: number;
            /** @description Whether it is still being written. */
            being_written: boolean;
        };
        /** @description Where the arm was over a stretch of a recording. */
        RecordedStates: {
            /**
             * Format: int64
             * @description When its times begin, in milliseconds since 1970-01-01T00:00:00Z; none where it holds nothing that could be read.
             */
            begin_ms?: number | null;
            /**
             * Format: double
             * @description So close together the samples stand at the most, in seconds; 0 where all that say something new are there.
             */
            spacing_s: number;
            /** @description What the arm told, the oldest first. Between two that are the same it did not move. */
            samples: components["schemas"]["SampleView"][];
        };
        /** @description What the arm told at one moment. */
        SampleView: {
            /**
             * Format: double
             * @description When, in seconds since the times of the recording begin.
             */
            at_s: number;
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
        };
        /** @description A drawing that is to be planned: a file, the text that the options tell or both, or a test card. */
        NewDrawing: {
            /**
             * @description The name of the file: its ending tells what kind it is.
             * @default null
             */
            name: string | null;
            /**
             * @description What the file holds, in Base64 (RFC 4648).
             * @default null
             */
            file: string | null;
            /**
             * @description How it is to be drawn, as the arguments of `dobot draw`.
             * @default {
             *       "what": {
             *         "text": null,
             *         "font": null,
             *         "height": null,
             *         "align": null,
             *         "card": null,
             *         "card_passes": null,
             *         "card_size": null,
             *         "card_gap": null,
             *         "card_label": null,
             *         "layers": null,
             *         "layer": [],
             *         "only": [],
             *         "no_crop": false,
             *         "hide": false,
             *         "hatch": null,
             *         "hatch_angle": 45,
             *         "hatch_style": "lines",
             *         "hatch_inset": 0,
             *         "cross": false,
             *         "shade": null,
             *         "spacing": null,
             *         "brightness": 0,
             *         "contrast": 0,
             *         "gamma": 1,
             *         "threshold": null,
             *         "levels": null,
             *         "invert": false
             *       },
             *       "place": {
             *         "paper_size": null,
             *         "landscape": false,
             *         "corner": null,
             *         "fit": false,
             *         "scale": null,
             *         "at": null,
             *         "mirror": false,
             *         "grid": null,
             *         "gap": 5,
             *         "rotate": 0,
             *         "margin": 0,
             *         "clip": false,
             *         "pen_down": null,
             *         "paper": null,
             *         "offset": 0
             *       },
             *       "tool": {
             *         "pen": "fineliner",
             *         "laser": null,
             *         "lift": null,
             *         "speed": null,
             *         "travel_speed": null,
             *         "passes": null,
             *         "passes_by": "layer",
             *         "kerf": 0,
             *         "lead_in": 0,
             *         "overcut": 0,
             *         "tabs": 0,
             *         "tab_width": 1,
             *         "acceleration": 100
             *       },
             *       "way": {
             *         "tolerance": 0.05,
             *         "join": null,
             *         "drop_doubles": false,
             *         "keep_order": false,
             *         "tries": 80000,
             *         "seed": 1,
             *         "from": null
             *       }
             *     }
             */
            options: components["schemas"]["Options"];
        };
        /**
         * @description What a person asks for. [`DrawingRequest::new`] makes [`Settings`](crate::Settings) of it; `dobot draw` reads it from its
         *     arguments, any other client from JSON:
         *
         *     ```
         *     use dobot_draw::{DrawingRequest, Materials, Options, Subject};
         *
         *     let asked = r#"{"what": {"text": "Hello"}, "place": {"at": [210, 20]}, "tool": {"pen": "marker"}}"#;
         *     let options: Options = serde_json::from_str(asked)?;
         *     let text = Subject::of_text(&options.what).expect("there is one");
         *     let asked = DrawingRequest::new(options, text, &Materials::built_in())?;
         *     let (prepared, _) = asked.prepare(None, -40.0)?;
         *     assert!(prepared.plan.summary().drawn_mm > 40.0); // of letters 10 mm high
         *     # Ok::<(), Box<dyn std::error::Error>>(())
         *     ```
         */
        Options: {
            /**
             * @description What is drawn.
             * @default {
             *       "text": null,
             *       "font": null,
             *       "height": null,
             *       "align": null,
             *       "card": null,
             *       "card_passes": null,
             *       "card_size": null,
             *       "card_gap": null,
             *       "card_label": null,
             *       "layers": null,
             *       "layer": [],
             *       "only": [],
             *       "no_crop": false,
             *       "hide": false,
             *       "hatch": null,
             *       "hatch_angle": 45,
             *       "hatch_style": "lines",
             *       "hatch_inset": 0,
             *       "cross": false,
             *       "shade": null,
             *       "spacing": null,
             *       "brightness": 0,
             *       "contrast": 0,
             *       "gamma": 1,
             *       "threshold": null,
             *       "levels": null,
             *       "invert": false
             *     }
             */
            what: components["schemas"]["ContentOptions"];
            /**
             * @description Where it goes.
             * @default {
             *       "paper_size": null,
             *       "landscape": false,
             *       "corner": null,
             *       "fit": false,
             *       "scale": null,
             *       "at": null,
             *       "mirror": false,
             *       "grid": null,
             *       "gap": 5,
             *       "rotate": 0,
             *       "margin": 0,
             *       "clip": false,
             *       "pen_down": null,
             *       "paper": null,
             *       "offset": 0
             *     }
             */
            place: components["schemas"]["PlaceOptions"];
            /**
             * @description With what it is drawn.
             * @default {
             *       "pen": "fineliner",
             *       "laser": null,
             *       "lift": null,
             *       "speed": null,
             *       "travel_speed": null,
             *       "passes": null,
             *       "passes_by": "layer",
             *       "kerf": 0,
             *       "lead_in": 0,
             *       "overcut": 0,
             *       "tabs": 0,
             *       "tab_width": 1,
             *       "acceleration": 100
             *     }
             */
            tool: components["schemas"]["ToolOptions"];
            /**
             * @description How it is drawn.
             * @default {
             *       "tolerance": 0.05,
             *       "join": null,
             *       "drop_doubles": false,
             *       "keep_order": false,
             *       "tries": 80000,
             *       "seed": 1,
             *       "from": null
             *     }
             */
            way: components["schemas"]["PathOptions"];
        };
        /** @description What is drawn. */
        ContentOptions: {
            /**
             * @description A text, alone or below the files; \n begins a new line
             * @default null
             */
            text: string | null;
            /**
             * @description The letters of `what.text`: a single-line font (sans, script, serif, gothic), or any installed font
             *     (default: sans)
             * @default null
             */
            font: string | null;
            /**
             * Format: double
             * @description How tall the capitals of `what.text` are, in mm (default: 10)
             * @default null
             */
            height: number | null;
            /**
             * @description Where the lines of `what.text` meet: left, center or right (default: left)
             * @default null
             */
            align: components["schemas"]["Align"] | null;
            /**
             * @description A test card for the laser: fields burned at these speeds in mm/s, once, twice and so on
             * @default null
             */
            card: number[] | null;
            /**
             * Format: uint32
             * @description How often the lowest row of the test card is burned (default: 3)
             * @default null
             */
            card_passes: number | null;
            /**
             * Format: double
             * @description How wide and high the fields of the test card are, in mm (default: 6)
             * @default null
             */
            card_size: number | null;
            /**
             * Format: double
             * @description How far the fields of the test card lie apart, in mm (default: 2)
             * @default null
             */
            card_gap: number | null;
            /**
             * @description What is burned below the test card (default: the name of the material, and the day)
             * @default null
             */
            card_label: string | null;
            /**
             * @description Make layers of the colours or outermost groups of an SVG file, or of the layers of others: each is drawn
             *     for itself, and the arm waits for its pen
             * @default null
             */
            layers: components["schemas"]["LayersBy"] | null;
            /**
             * @description Draw a layer with a pen or material of its own
             * @default []
             */
            layer: components["schemas"]["LayerTool"][];
            /**
             * @description Draw these layers only, by name: several with commas between them, or one for each `what.only`
             * @default []
             */
            only: string[];
            /**
             * @description Draw what lies beyond the page of an SVG file too, instead of cutting it at the page's edge
             * @default false
             */
            no_crop: boolean;
            /**
             * @description Leave out what lies under filled shapes that are painted over it, white ones too, as in a picture
             * @default false
             */
            hide: boolean;
            /**
             * @description Hatch filled areas, with lines so far apart, in mm (default: what suits the pen or material)
             * @default null
             */
            hatch: components["schemas"]["Spacing"] | null;
            /**
             * Format: double
             * @description The direction of the hatching, in degrees from left to right counterclockwise
             * @default 45
             */
            hatch_angle: number;
            /**
             * @description What areas are hatched with: lines, concentric (the outline again and again, farther inside) or
             *     spiral (the same in one line)
             * @default lines
             */
            hatch_style: components["schemas"]["HatchStyle"];
            /**
             * Format: double
             * @description How far the hatching stays away from the edge, in mm: half the width of the pen keeps the ink inside
             * @default 0
             */
            hatch_inset: number;
            /**
             * @description Hatch crosswise
             * @default false
             */
            cross: boolean;
            /**
             * @description How a picture becomes ink: hatch, lines, spiral, flow, stipple, tsp (one line from dot to dot) or outline
             * @default null
             */
            shade: components["schemas"]["ShadingStyle"] | null;
            /**
             * Format: double
             * @description How far the lines or dots of a picture lie apart, or the lines of the test card, in mm on the paper
             * @default null
             */
            spacing: number | null;
            /**
             * Format: double
             * @description Make a picture lighter, or darker below 0: from -100 to 100 percent
             * @default 0
             */
            brightness: number;
            /**
             * Format: double
             * @description Set the tones of a picture farther apart, or nearer below 0: from -100 to 100 percent
             * @default 0
             */
            contrast: number;
            /**
             * Format: double
             * @description Make the middle tones of a picture lighter above 1, darker below
             * @default 1
             */
            gamma: number;
            /**
             * Format: double
             * @description Make a picture black where it is darker than so much, and white elsewhere: between 0 (white) and 1
             * @default null
             */
            threshold: number | null;
            /**
             * Format: uint8
             * @description How many tones beside white the styles outline and hatch tell apart, from 1 to 8 (default: 4)
             * @default null
             */
            levels: number | null;
            /**
             * @description Draw the light parts of a picture instead of the dark ones
             * @default false
             */
            invert: boolean;
        };
        /** @description Where lines of different lengths meet. */
        Align: "left" | "center" | "right";
        /** @description What makes a layer of an SVG file. */
        LayersBy: "color" | "group" | "nothing";
        /** @description A layer that has a pen or a material of its own: `NAME=PEN`. */
        LayerTool: {
            /** @description The layer's name. */
            name: string;
            /** @description The name of its pen or material. */
            pen: string;
        };
        /** @description How far apart the lines of a hatching are: `auto` or millimetres. */
        Spacing: number | components["schemas"]["Auto"];
        /** @description The word `auto`. */
        Auto: "auto";
        /** @description The lines that an area is filled with. */
        HatchStyle: "lines" | "concentric" | "spiral";
        /** @description What is drawn of a picture. */
        ShadingStyle: "outline" | "lines" | "spiral" | "flow" | "stipple" | "tsp" | "hatch";
        /** @description Where it goes. */
        PlaceOptions: {
            /**
             * @description The sheet that it goes on: a3, a4, a5, a6, letter, legal, or `210x148` in mm; the page of the file
             *     keeps its upper left corner
             * @default null
             */
            paper_size: components["schemas"]["PaperSize"] | null;
            /**
             * @description The longer side of the sheet lies from left to right
             * @default false
             */
            landscape: boolean;
            /**
             * @description Where the lower left corner of the sheet lies, in mm: the one that is nearest to you behind the arm,
             *     on the left (default: the sheet lies in the middle before the arm)
             * @default null
             */
            corner: number[] | null;
            /**
             * @description As large as the sheet or the drawing area allows
             * @default false
             */
            fit: boolean;
            /**
             * Format: double
             * @description Times the true size
             * @default null
             */
            scale: number | null;
            /**
             * @description Where the middle of the drawing goes, or that of the sheet, in mm (default: the middle of the drawing
             *     area)
             * @default null
             */
            at: number[] | null;
            /**
             * @description Change left and right
             * @default false
             */
            mirror: boolean;
            /**
             * @description Draw copies side by side, in columns and rows as in 3x2; several files one in each cell, then from the
             *     first again
             * @default null
             */
            grid: components["schemas"]["Grid"] | null;
            /**
             * Format: double
             * @description How far the copies or files of `place.grid` lie apart, and how far `what.text` stands below a file, in mm of the file
             * @default 5
             */
            gap: number;
            /**
             * Format: double
             * @description Turn it counterclockwise
             * @default 0
             */
            rotate: number;
            /**
             * Format: double
             * @description Leave so much of the sheet or the drawing area empty along its edges, in mm
             * @default 0
             */
            margin: number;
            /**
             * @description Cut off what lies beyond the sheet or out of the arm's reach, instead of refusing the drawing
             * @default false
             */
            clip: boolean;
            /**
             * Format: double
             * @description Z where the pen draws, in mm (default: where the arm stands; a virtual arm -40)
             * @default null
             */
            pen_down: number | null;
            /**
             * @description Three points of the paper that the pen has touched, for paper that is not level; with `place.paper_size`
             *     first the lower left corner of the sheet, then another place on its lower edge
             * @default null
             */
            paper: number[] | null;
            /**
             * Format: double
             * @description Draw so much higher, in mm; negative presses harder
             * @default 0
             */
            offset: number;
        };
        /** @description How large a sheet is: `a6` to `a3`, `letter`, `legal`, or width and height in mm as in `210x148`. */
        PaperSize: string;
        /** @description Copies or files in columns and rows, as in `3x2`: three beside each other, two below each other. */
        Grid: string;
        /** @description With what it is drawn. */
        ToolOptions: {
            /**
             * @description Draw with this pen
             * @default fineliner
             */
            pen: string;
            /**
             * @description Burn this material with the laser
             * @default null
             */
            laser: string | null;
            /**
             * Format: double
             * @description How far the pen is lifted to travel, in mm
             * @default null
             */
            lift: number | null;
            /**
             * Format: double
             * @description Speed while drawing or burning, in mm/s
             * @default null
             */
            speed: number | null;
            /**
             * Format: double
             * @description Speed between the strokes, in mm/s
             * @default null
             */
            travel_speed: number | null;
            /**
             * Format: uint32
             * @description Draw or burn everything so often; a pen goes over each line so often before it is lifted
             * @default null
             */
            passes: number | null;
            /**
             * @description What the laser burns so often before it goes on: a shape, or all of the layer
             * @default layer
             */
            passes_by: components["schemas"]["PassesBy"];
            /**
             * Format: double
             * @description How wide the laser burns, in mm: closed shapes are cut larger by half of it, and holes in them smaller;
             *     below 0 the other way round
             * @default 0
             */
            kerf: number;
            /**
             * Format: double
             * @description Begin each cut so far beside the shape, in mm
             * @default 0
             */
            lead_in: number;
            /**
             * Format: double
             * @description Go on so far behind where a cut began, in mm
             * @default 0
             */
            overcut: number;
            /**
             * Format: uint32
             * @description Leave so many places of each shape uncut, so that it does not fall out
             * @default 0
             */
            tabs: number;
            /**
             * Format: double
             * @description How wide these places are, in mm
             * @default 1
             */
            tab_width: number;
            /**
             * Format: double
             * @description Acceleration, in mm/s²
             * @default 100
             */
            acceleration: number;
        };
        /** @description What a laser burns several times before it goes on. */
        PassesBy: "shape" | "layer";
        /** @description How it is drawn. */
        PathOptions: {
            /**
             * Format: double
             * @description How far the drawn path may leave the wanted one, in mm
             * @default 0.05
             */
            tolerance: number;
            /**
             * Format: double
             * @description Join strokes whose ends lie so near to each other, in mm (default: the tolerance)
             * @default null
             */
            join: number | null;
            /**
             * @description Leave out what lies on other lines, and of shapes to cut out only whole ones
             * @default false
             */
            drop_doubles: boolean;
            /**
             * @description Draw in the order of the file
             * @default false
             */
            keep_order: boolean;
            /**
             * Format: uint32
             * @description How long to look for the shortest way with the pen up: so many tries, fewer from 10,000 strokes on
             * @default 80000
             */
            tries: number;
            /**
             * Format: uint64
             * @description Look elsewhere: the same number gives the same order
             * @default 1
             */
            seed: number;
            /**
             * @description Begin later: at a layer, a stroke or a share of the ink, as in layer:red, stroke:120 or 40%
             * @default null
             */
            from: components["schemas"]["StartFrom"] | null;
        };
        /**
         * @description Where to begin, so that a drawing can be finished that was broken off: `layer:NAME`, `stroke:NUMBER` or
         *     a share such as `40%`.
         */
        StartFrom: string;
        /** @description A drawing, planned or on the way to it. */
        DrawingView: {
            /**
             * Format: uint64
             * @description Its number.
             */
            drawing: number;
            /** @description What a person calls it. */
            title: string;
            /** @description How far it is. */
            phase: components["schemas"]["DrawingPhase"];
            /** @description Why it cannot be planned. */
            problem?: components["schemas"]["Problem"] | null;
            /** @description What was planned. */
            plan?: components["schemas"]["DrawingPlan"] | null;
        };
        /** @description How far a drawing is. */
        DrawingPhase: "waiting" | "planning" | "planned" | "failed";
        /** @description What was planned. */
        DrawingPlan: {
            /**
             * Format: double
             * @description How much larger than its file says it becomes.
             */
            scale: number;
            /** @description Whether it burns with a laser. */
            burns: boolean;
            /** @description What the pen does not show as the file says. */
            warnings: string[];
            /** @description Where the arm waits for a person, and what that one reads there. */
            pauses: string[];
            /** @description Why the arm may not draw it from where it stands. */
            refused?: components["schemas"]["Problem"] | null;
            /** @description All of it in time, pass by pass and vector by vector. */
            timeline: components["schemas"]["Timeline"];
        };
        /**
         * @description A drawing in time, for a page that lets a person go to any moment of it.
         *
         *     All numbers are millimetres in the base frame (X forward, Y to the left, Z up) and seconds from
         *     the beginning. Tables are columns of one length, which is far smaller than rows with names.
         *
         *     **What is at time `t`.** The path is straight from row to row, at even speed. Find the last row
         *     `i` with `path.t_s[i] <= t` (binary search, the column rises or stays) and go the share
         *     `(t - t_s[i]) / (t_s[i + 1] - t_s[i])` of the way to row `i + 1`; at the last row the drawing is
         *     over. The tool is never farther than 0.05 mm from there. On the paper are all lines up to row
         *     `i`, and the piece from row `i` to the tool if row `i + 1` has ink 1. The pen or the laser leaves
         *     ink just then if row `i + 1` has ink 1.
         *
         *     **Which move is it.** Find the last row of `moves` with `from_s <= t`, in the same way: it ends
         *     where the next one begins, the last one at `duration_s`.
         *
         *     **What to draw.** Go through the path: a row with ink 2 begins a line (it is a dot, if none
         *     follows), a row with ink 1 goes on with it, a row with ink 0 ends it. The colour of a line is
         *     that of its pass (of the move at its time), or comes from `error_mm`.
         */
        Timeline: {
            /**
             * Format: uint32
             * @description What this looks like: 1. A page refuses what it does not know.
             */
            version: number;
            /**
             * Format: double
             * @description How long the drawing takes.
             */
            duration_s: number;
            /**
             * Format: double
             * @description How often the arm was looked at; only what is needed is kept in `path`.
             */
            tick_s: number;
            /** @description What holds all of the path: the least and the most of X, Y and Z. */
            bounds_mm: number[][];
            /** @description The passes in their order. */
            passes: components["schemas"]["PassFigures"][];
            /** @description What the tool does, one after the other. */
            moves: components["schemas"]["Moves"];
            /** @description Where the tool is, and what it leaves. */
            path: components["schemas"]["Path"];
        };
        /** @description The figures of a pass. */
        PassFigures: {
            /** @description What it is called. */
            name: string;
            /** @description Red, green and blue, where the file tells a colour. */
            color?: number[] | null;
            /** @description What draws: `pen` or `laser`. */
            tool: components["schemas"]["Tool"];
            /**
             * Format: uint
             * @description How many strokes, each as often as it is drawn.
             */
            strokes: number;
            /**
             * Format: uint
             * @description How many vectors, and so packets.
             */
            vectors: number;
            /**
             * Format: double
             * @description How long its lines on the paper are, in mm.
             */
            ink_mm: number;
            /**
             * Format: double
             * @description How far the tool goes without leaving ink, the way to its first stroke included, in mm.
             */
            travel_mm: number;
            /**
             * Format: double
             * @description From the end of the pass before to its own, in seconds.
             */
            time_s: number;
            /**
             * Format: double
             * @description How far its ink lies from the wanted path at most, in mm.
             */
            error_mm: number;
        };
        /** @description What the tool does, one row for each. */
        Moves: {
            /** @description What the numbers in `kind` mean. */
            kinds: string[];
            /** @description What it does, as an index in `kinds`. */
            kind: number[];
            /** @description In which pass, as an index in `passes`. */
            pass: number[];
            /** @description For which stroke, from 0, counted through all passes. */
            stroke: number[];
            /** @description When it begins. */
            from_s: number[];
        };
        /** @description Where the tool is, one row for each moment that matters. */
        Path: {
            /** @description When. */
            t_s: number[];
            /** @description Forward. */
            x_mm: number[];
            /** @description To the left. */
            y_mm: number[];
            /** @description Up. */
            z_mm: number[];
            /** @description 0: no ink; 1: a line from the row before to here; 2: a dot, with which a line may begin. */
            ink: number[];
            /** @description How far the ink here lies from the wanted path; 0 where there is none. */
            error_mm: number[];
        };
        /** @description What of a drawing is to be a job. */
        DrawingJob: {
            /** @description Which part. */
            part?: components["schemas"]["DrawingPart"];
        };
        /** @description What of a drawing a job is to do. */
        DrawingPart: "whole" | "frame";
        /** @description A pen, or a material for the laser. */
        MaterialView: {
            /** @description Its name. */
            name: string;
            /** @description What draws on it: `pen` or `laser`. */
            tool: components["schemas"]["Tool"];
        };
        /** @description A format of files that can be drawn. */
        Format: {
            /** @description The name, as in `HP-GL`. */
            name: string;
            /** @description The extensions of its files in lower case, without dots; the usual one first. */
            extensions: string[];
            /** @description The MIME type. */
            mime_type: string;
            /** @description What its files hold. */
            contents: components["schemas"]["Contents"];
        };
        /** @description What the files of a format hold. */
        Contents: "page" | "shapes" | "lines" | "picture";
        /** @description A token, without its secret. */
        TokenView: {
            /** @description Who it is for: 1 to 40 letters, digits, dots, dashes and spaces. */
            name: string;
            /** @description What its holder may do. */
            role: components["schemas"]["Role"];
            /**
             * @description Whether it is for several people, each of whom is who he calls himself; any other one is that of one person, by its name.
             * @default false
             */
            shared: boolean;
        };
        /** @description What a client may do; each role may do what those before it may. */
        Role: "watch" | "queue" | "control" | "admin";
        /** @description A token that was just made. */
        NewToken: {
            /** @description Who it is for. */
            name: string;
            /** @description What its holder may do. */
            role: components["schemas"]["Role"];
            /** @description What the holder shows; nobody is shown it again. */
            secret: string;
        };
        /**
         * @description All that can be known of a world at a moment, to be kept, sent and drawn. Lengths are told to a
         *     thousandth of a millimetre.
         */
        WorldState: {
            /**
             * Format: double
             * @description The time, in seconds since power-up.
             */
            time_s: number;
            /** @description Where the arm really is; nothing where it has not been told yet. */
            arm?: components["schemas"]["TrueArm"] | null;
            /** @description What is mounted at its end. */
            tool: components["schemas"]["WorldTool"];
            /**
             * Format: double
             * @description The height of the table in the base frame.
             */
            table_z_mm: number;
            /** @description The paper. */
            paper?: components["schemas"]["Paper"] | null;
            /** @description The objects, those in the grip where they are now. */
            objects: components["schemas"]["WorldObject"][];
            /**
             * @description The names of the objects that move with the tool: the one in its grip first, then those
             *     that stand on it.
             */
            held: string[];
            /** @description The ink, in the order in which it was drawn. */
            strokes: components["schemas"]["InkStroke"][];
            /** @description What the laser burned on its way. */
            burns: components["schemas"]["Burn"][];
            /** @description What the laser burned where it stood. */
            holes: components["schemas"]["Hole"][];
            /**
             * Format: uint64
             * @description How many events there were.
             */
            event_count: number;
            /** @description The last of them, at most 100, the oldest first. */
            events: components["schemas"]["Happened"][];
        };
        /** @description Where an arm really is and what acts at its tool. */
        TrueArm: {
            /**
             * Format: double
             * @description Joint 1.
             */
            base_deg: number;
            /**
             * Format: double
             * @description Joint 2.
             */
            rear_deg: number;
            /**
             * Format: double
             * @description Joint 3.
             */
            fore_deg: number;
            /**
             * Format: double
             * @description Joint 4.
             */
            servo_deg: number;
            /**
             * Format: double
             * @description Forward.
             */
            x_mm: number;
            /**
             * Format: double
             * @description To the left.
             */
            y_mm: number;
            /**
             * Format: double
             * @description The height of the wrist in the base frame.
             */
            z_mm: number;
            /**
             * Format: double
             * @description How the tool is turned in the base frame.
             */
            rotation_deg: number;
            /**
             * Format: double
             * @description The height of the tip above the table.
             */
            tip_mm: number;
            /** @description Whether the pump runs. */
            pump: boolean;
            /** @description Whether the laser is on. */
            laser: boolean;
            /**
             * Format: double
             * @description The angle of the gripper's servo.
             */
            gripper_deg: number;
            /**
             * Format: double
             * @description How far the fingers of a gripper are apart; 0 with another tool.
             */
            opening_mm: number;
        };
        /**
         * @description The tool of a scene.
         *
         *     Heights are measured where a person measures them: the arm is lowered until the tip touches the
         *     table, and the z that the arm tells then is `down_z_mm`. From there the height of the tip above
         *     the table is z less `down_z_mm`, wherever the wrist and the table really are.
         */
        WorldTool: {
            /**
             * Format: double
             * @description Z of the wrist when the tip touches the table, in the base frame.
             */
            down_z_mm: number;
            /**
             * Format: double
             * @description How far the tip may be pressed into something before that counts as a collision: a pen has
             *     a spring, a cup is soft.
             */
            give_mm: number;
            /** @description Which tool it is, and how it acts on the scene. */
            kind: components["schemas"]["ToolAction"];
        };
        /** @description How a tool acts on the scene. */
        ToolAction: {
            /** @constant */
            type: "pen";
            /**
             * Format: double
             * @description How wide its line is.
             */
            width_mm: number;
        } | {
            /** @constant */
            type: "laser";
            /**
             * Format: double
             * @description From its tip down to its focus.
             */
            focus_mm: number;
            /**
             * Format: double
             * @description How far above and below the focus it still burns.
             */
            depth_mm: number;
            /**
             * Format: double
             * @description Its power, in watts; the protocol knows on and off only.
             */
            power_w: number;
        } | {
            /** @constant */
            type: "suction_cup";
            /**
             * Format: double
             * @description How wide it is: it holds only what it covers as a whole.
             */
            diameter_mm: number;
            /**
             * Format: double
             * @description The heaviest load, in grams.
             */
            lifts_g: number;
        } | {
            /** @constant */
            type: "gripper";
            /**
             * Format: double
             * @description Between the fingers with the servo at 0 degrees.
             */
            open_mm: number;
            /**
             * Format: double
             * @description Between the fingers with the servo at 90 degrees.
             */
            closed_mm: number;
            /**
             * Format: double
             * @description The heaviest load, in grams.
             */
            lifts_g: number;
        };
        /** @description A sheet of paper, with its sides along X and Y. It has no thickness. */
        Paper: {
            /** @description Its corner with the least X and Y. */
            from_mm: number[];
            /** @description Its corner with the largest X and Y. */
            to_mm: number[];
        };
        /** @description A thing on the table, or in the grip of the tool. */
        WorldObject: {
            /** @description What it is called; no other object is. */
            name: string;
            /** @description Its shape and size. */
            shape: components["schemas"]["Shape"];
            /**
             * Format: double
             * @description What it weighs, in grams.
             */
            mass_g: number;
            /** @description Its colour, as `#rrggbb`. */
            color: string;
            /** @description Where its middle is. */
            at_mm: number[];
            /**
             * Format: double
             * @description How it is turned about the vertical, counter-clockwise.
             */
            turn_deg: number;
            /**
             * Format: double
             * @description How high its underside is above the table.
             */
            bottom_mm: number;
        };
        /** @description The shapes of objects; all stand upright. */
        Shape: {
            /** @constant */
            type: "box";
            /** @description The sides. */
            size_mm: number[];
        } | {
            /** @constant */
            type: "cylinder";
            /**
             * Format: double
             * @description How wide it is.
             */
            diameter_mm: number;
            /**
             * Format: double
             * @description How tall it is.
             */
            height_mm: number;
        };
        /** @description A line of ink. */
        InkStroke: {
            /** @description Where the pen went while it was down; a single point is a dot. */
            points_mm: number[][];
        };
        /** @description A line that the laser burned at about one speed. */
        Burn: {
            /** @description Where the laser went. */
            points_mm: number[][];
            /**
             * Format: double
             * @description With which power, in watts.
             */
            power_w: number;
            /**
             * Format: double
             * @description How fast, in mm/s.
             */
            speed_mm_s: number;
        };
        /** @description A hole that the laser burned while it stood. */
        Hole: {
            /** @description Where. */
            at_mm: number[];
            /**
             * Format: double
             * @description With which power, in watts.
             */
            power_w: number;
            /**
             * Format: double
             * @description For how long, in seconds.
             */
            time_s: number;
        };
        /** @description Something that happened, and when. */
        Happened: {
            /**
             * Format: double
             * @description When, in seconds since power-up.
             */
            at_s: number;
        } & ({
            /** @constant */
            event: "picked_up";
            /** @description The object. */
            object: string;
            /**
             * Format: uint
             * @description How many others stand on it.
             */
            with: number;
        } | {
            /** @constant */
            event: "too_heavy";
            /** @description The object. */
            object: string;
            /**
             * Format: double
             * @description What it weighs, with all that stands on it.
             */
            mass_g: number;
            /**
             * Format: double
             * @description What the tool lifts.
             */
            lifts_g: number;
        } | {
            /** @constant */
            event: "draws_air";
            /** @description The object. */
            object: string;
            /**
             * Format: double
             * @description How far the cup stands out.
             */
            by_mm: number;
        } | {
            /** @constant */
            event: "dropped";
            /** @description The object. */
            object: string;
            /** @description What it came to rest on. */
            onto: string;
            /**
             * Format: double
             * @description How far it fell.
             */
            fell_mm: number;
        } | {
            /** @constant */
            event: "collided";
            /** @description The tool, or the object that it holds. */
            what: string;
            /** @description What is in the way. */
            with: string;
            /**
             * Format: double
             * @description How deep.
             */
            depth_mm: number;
            /** @description Where. */
            at_mm: number[];
        } | {
            /** @constant */
            event: "burns_on_the_spot";
            /** @description Where. */
            at_mm: number[];
            /**
             * Format: double
             * @description For how long it has by now.
             */
            time_s: number;
        } | {
            /** @constant */
            event: "off_paper";
            /** @description Where. */
            at_mm: number[];
        } | {
            /** @constant */
            event: "lost";
        });
        /** @description A world. */
        SceneText: {
            /** @description Its TOML text, as those of `examples/scenes`. */
            scene: string;
        };
        /** @description What is to go wrong. */
        NewFaults: {
            /** @description The faults, as `dobot arm --fault` takes them; times count from now. */
            faults: string[];
            /**
             * Format: uint64
             * @description What chance begins with: the same faults with the same seed do the same.
             * @default 0
             */
            seed: number;
        };
        /** @description A fleet, as one of its stations sees it. */
        FleetView: {
            /** @description What the station that tells this is called in the fleet. */
            name: string;
            /**
             * Format: double
             * @description The time since that station started, in seconds.
             */
            at_s: number;
            /** @description All stations that have been seen, this one among them, by name. */
            members: components["schemas"]["Member"][];
        };
        /** @description A station of a fleet, as another one sees it. */
        Member: {
            /** @description What it is called, as in `desk-3`. */
            name: string;
            /** @description The number that it goes by as long as its data live, 32 hexadecimal digits: two stations may claim one name. */
            id: string;
            /** @description Whether it is the station that tells this. */
            here: boolean;
            /** @description Whether it can be reached. */
            presence: components["schemas"]["Presence"];
            /**
             * Format: double
             * @description When it was heard last, in seconds since the start of the station that tells this: by no other clock.
             */
            heard_at_s: number;
            /** @description What it is; absent until it has told. */
            about?: components["schemas"]["MemberAbout"] | null;
            /** @description What it told last; absent until it has told anything. */
            state?: components["schemas"]["State"] | null;
        };
        /** @description Whether a station of a fleet can be reached. */
        Presence: {
            /** @constant */
            type: "present";
        } | {
            /** @constant */
            type: "away";
        } | {
            /** @constant */
            type: "refused";
            /** @description Why, and what to do. */
            problem: components["schemas"]["Problem"];
        };
        /** @description What a station of a fleet is. */
        MemberAbout: {
            /** @description The version of its program. */
            version: string;
            /** @description Where its own page is, as others reach it; absent where it is for its own machine only. */
            page?: string | null;
            /** @description The groups that it belongs to, as in `room-2`. */
            groups: string[];
            /** @description What it has for work, as in `pen`, `laser`, `a5`. */
            offers: string[];
            /** @description Whether its arm is a virtual one. */
            is_virtual: boolean;
            /** @description What it does with work of the fleet; absent where it takes none. */
            takes_work?: components["schemas"]["TakesWork"] | null;
            /**
             * Format: uint16
             * @description How many virtual arms it gives to those without an arm; absent where it gives none.
             */
            gives_arms?: number | null;
            /** @description The station that gave this virtual arm to somebody; absent where it is no such arm. */
            given_by?: string | null;
        };
        /** @description What a station does with the work of its fleet. */
        TakesWork: "queue" | "start";
        /** @description Whom to stop. */
        FleetStop: {
            /**
             * @description Which stations; all where it is not said.
             * @default all
             */
            to: components["schemas"]["Recipients"];
            /** @description Why, for those who find their arm stopped. */
            reason?: string | null;
        };
        /** @description Which stations of a fleet. */
        Recipients: "all" | {
            group: string;
        } | {
            members: string[];
        };
        /** @description What one station of a fleet answered. */
        MemberAnswer: {
            /** @description What it is called. */
            member: string;
            /** @description The number that it goes by. */
            id: string;
            /** @description Its answer; where none came, a problem says so: what was asked may have been done all the same. */
            answer: components["schemas"]["ApiAnswer"];
            /**
             * Format: double
             * @description How long the answer took, in milliseconds.
             */
            took_ms: number;
        };
        /** @description What a station answers. */
        ApiAnswer: {
            /**
             * Format: uint16
             * @description The status of HTTP.
             */
            status: number;
            /** @description The body: JSON, a problem where the status is 400 or above, and a text where it is no JSON. */
            body: unknown;
        };
        /** @description A request to several stations at once. */
        FleetRequest: {
            /** @description Which stations. */
            to: components["schemas"]["Recipients"];
            /** @description The method, as in `POST`. */
            method: string;
            /** @description The path with its query, as in `/api/v1/jobs/pause`. */
            path: string;
            /**
             * @description The token of a lease of the one station that is asked.
             * @default null
             */
            lease: string | null;
            /**
             * @description What the sender calls this request.
             * @default null
             */
            key: string | null;
            /**
             * @description The body, where there is one.
             * @default null
             */
            body: unknown;
        };
        /** @description A drawing or a program for any arm: one of both. */
        FleetWork: {
            /**
             * @description A drawing; the station that takes it plans it for its own arm.
             * @default null
             */
            drawing: components["schemas"]["NewDrawing"] | null;
            /**
             * @description A job. Its places are those of this station's arm: one that is calibrated otherwise does not take it.
             * @default null
             */
            job: components["schemas"]["NewJob"] | null;
            /**
             * @description What an arm has to have for it, as in `["pen", "a5"]`.
             * @default []
             */
            needs: string[];
            /**
             * @description Whose it is; without it, that of whoever submits it.
             * @default null
             */
            student: string | null;
            /**
             * @description The group of that one.
             * @default null
             */
            group: string | null;
        };
        /** @description A drawing or a program that any arm of the fleet may do, once. */
        WorkView: {
            /** @description What it goes by: 32 hexadecimal digits. */
            id: string;
            /** @description What a person calls it. */
            title: string;
            /** @description Whose it is. */
            student: string;
            /** @description The group of that one. */
            group?: string | null;
            /** @description What an arm has to have for it, as in `pen`, `a5`. */
            needs: string[];
            /**
             * Format: int64
             * @description When it was submitted, in milliseconds since 1970-01-01T00:00:00Z.
             */
            submitted_ms: number;
            /** @description How far it is. */
            phase: components["schemas"]["WorkPhase"];
            /**
             * @description Why nobody knows whether it is or will be drawn: it is in doubt, and no other arm gets it until that is known or a
             *     person decides so.
             */
            doubt?: string | null;
            /** @description Why it waits, or how it ended. */
            reason?: string | null;
            /** @description The station that was offered it, or has it. */
            member?: components["schemas"]["WorkMember"] | null;
            /** @description The job there, as it was heard of last. */
            job?: components["schemas"]["JobView"] | null;
            /** @description The stations from which a person has taken it, and what may have been drawn there. */
            before?: components["schemas"]["WorkBefore"][];
        };
        /** @description How far work for any arm is. */
        WorkPhase: "waiting" | "offered" | "taken" | "done" | "failed" | "cancelled";
        /** @description A station that work was offered to. */
        WorkMember: {
            /** @description What it is called. */
            name: string;
            /** @description The number that it goes by. */
            id: string;
        };
        /** @description A station from which a person has taken work that was in doubt or had failed. */
        WorkBefore: {
            /** @description Which. */
            member: components["schemas"]["WorkMember"];
            /** @description What of it may have been drawn there, in words. */
            drawn: string;
            /** @description Whether that station has answered since, so that nothing more of it is drawn there. */
            is_settled: boolean;
        };
        /** @description Work that a station offers: a drawing or a job. */
        FleetOffer: {
            /** @description What the station is called. */
            by: string;
            /** @description Whose it is. */
            student: string;
            /** @description A drawing, which is planned here. */
            drawing?: components["schemas"]["NewDrawing"] | null;
            /** @description A job. */
            job?: components["schemas"]["NewJob"] | null;
            /** @description The calibration of the arm that the job's places are meant for, as ten numbers. */
            made_for?: number[] | null;
        };
        /** @description The virtual arms that a station gives to those without an arm. */
        GivenArms: {
            /**
             * Format: uint16
             * @description So many it gives at a time.
             */
            most: number;
            /**
             * Format: uint64
             * @description One that nobody looks at ends after so long, in seconds.
             */
            unused_s: number;
            /** @description Those that are given. */
            arms: components["schemas"]["GivenArm"][];
        };
        /** @description A virtual arm that somebody was given: a station of the fleet like any other one. */
        GivenArm: {
            /** @description What it is called in the fleet. */
            name: string;
            /** @description Where its page is. */
            page: string;
        };
        /** @description A virtual arm that is wanted. */
        WantedVirtualArm: {
            /** @description What it is to be called in the fleet: 1 to 40 small letters of English, digits and hyphens, the first one a letter. */
            name: string;
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
            /**
             * @description By which name time slots know it: that of its token where this is one person's, or else what the client calls itself.
             * @default
             */
            person: string;
            /** @description The version of the station. */
            version: string;
            /**
             * Format: double
             * @description How long a jog button stays pressed without being said again, in seconds.
             */
            dead_man_s: number;
        };
        /** @description A packet that has passed between the station and the arm. */
        PacketView: {
            /** @constant */
            direction: "to_arm";
            /**
             * Format: double
             * @description When, in seconds since the station started.
             */
            at_s: number;
            /** @description Its 42 bytes, as hex digits. */
            bytes: string;
            /** @description What it means, by the dialect of the arm; nothing where it means nothing. */
            command?: components["schemas"]["Command"] | null;
            /** @description Why it means nothing. */
            problem?: string | null;
        } | {
            /** @constant */
            direction: "from_arm";
            /**
             * Format: double
             * @description When, in seconds since the station started.
             */
            at_s: number;
            /** @description Its 42 bytes, as hex digits. */
            bytes: string;
            /** @description What it means. */
            status?: components["schemas"]["Status"] | null;
        };
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
            type: "check_command";
            /** @description The command. */
            command: components["schemas"]["Command"];
        } | {
            /** @constant */
            type: "near";
            /**
             * Format: double
             * @description Forward of the axis of the base, in mm.
             */
            x_mm: number;
            /**
             * Format: double
             * @description To the left of it, in mm.
             */
            y_mm: number;
            /**
             * Format: double
             * @description The height of the wrist, in mm.
             */
            z_mm: number;
            /**
             * Format: double
             * @description The rotation of the tool, in degrees.
             */
            rotation_deg: number;
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
            type: "step";
            /** @description The button. */
            button: components["schemas"]["Button"];
            /**
             * Format: float
             * @description How far, in mm or degrees.
             */
            by: number;
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
            type: "lock";
            /** @description Why, for those who want to move the arm, as in "eyes on me". What is longer than 200 characters is cut. */
            message?: string | null;
        } | {
            /** @constant */
            type: "unlock";
        } | {
            /** @constant */
            type: "set_slots";
            /** @description The slots, in any order: up to 200, none of which overlaps another one. */
            slots: components["schemas"]["TimeSlot"][];
        } | {
            /** @constant */
            type: "show_slots";
        } | {
            /** @constant */
            type: "message";
            /** @description What. What is longer than 200 characters is cut. */
            text: string;
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
            type: "tell_angles";
        } | {
            /** @constant */
            type: "calibrate";
            /** @description What is known of the arm; nothing takes it to be as drawn. */
            calibration?: components["schemas"]["CalibrationFile"] | null;
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
            /**
             * @description What the sender calls this request, 1 to 64 visible characters: sent again with the same key, it queues no
             *     other job.
             */
            key?: string | null;
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
            type: "confirm_job";
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
        } | {
            /** @constant */
            type: "queue_again";
            /**
             * Format: uint64
             * @description Its number.
             */
            job: number;
            /**
             * @description What the sender calls this request, 1 to 64 visible characters: sent again with the same key, it queues no
             *     other job.
             */
            key?: string | null;
        } | {
            /** @constant */
            type: "move_job";
            /**
             * Format: uint64
             * @description Its number.
             */
            job: number;
            /**
             * Format: uint64
             * @description The number of the other one; without it the job comes last.
             */
            before?: number | null;
        } | {
            /** @constant */
            type: "forget_job";
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
            /** @description the page, or a file that it is made of */
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
    get_arm: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the facts */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ArmFacts"];
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
    put_policy: {
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
                 *       "text": "[table]\nz_mm = -60\n",
                 *       "check": true
                 *     }
                 */
                "application/json": components["schemas"]["PolicyText"];
            };
        };
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
             * @description - `job-running`: a job has the arm
             *     - `detecting`: the arm is finding out its dialect
             *     - `still-moving`: the arm still moves
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
             * @description - `bad-policy`: the text is no policy
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
            /** @description - `policy-file`: the policy cannot be written */
            500: {
                headers: {
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
    get_policy_text: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the text */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain; charset=utf-8": string;
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
    "post_policy_keep-outs": {
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
                 *       "text": "[table]\nz_mm = -60\n",
                 *       "edit": {
                 *         "type": "add",
                 *         "keep_out": {
                 *           "box": {
                 *             "x_mm": [
                 *               200,
                 *               260
                 *             ],
                 *             "y_mm": [
                 *               80,
                 *               140
                 *             ],
                 *             "z_mm": [
                 *               -60,
                 *               0
                 *             ]
                 *           }
                 *         }
                 *       }
                 *     }
                 */
                "application/json": components["schemas"]["EditPolicy"];
            };
        };
        responses: {
            /** @description the text */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PolicyDraft"];
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
             * @description - `bad-policy`: the text is no policy
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
    get_healthz: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description `ok` */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain; charset=utf-8": string;
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
    get_metrics: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the figures */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain; version=0.0.4; charset=utf-8": string;
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
    get_events: {
        parameters: {
            query?: {
                /** @description The most states in a second, 0 to 1000; without it every one comes (12.5 in a second, and those with events) */
                states?: number;
                /** @description Whether notices come; true without it */
                notices?: boolean;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the events */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": components["schemas"]["ServerSentEvent"];
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
    get_packets: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the packets */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": components["schemas"]["ServerSentEvent"];
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
    post_commands_check: {
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
                 *         "mode": "movl",
                 *         "gripper_deg": 0,
                 *         "pause_s": 0
                 *       }
                 *     }
                 */
                "application/json": components["schemas"]["CheckCommand"];
            };
        };
        responses: {
            /** @description the whole way is allowed */
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
             *     - `laser-disarmed`: the laser is disarmed
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
    post_arm_near: {
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
                 *       "x_mm": 200,
                 *       "y_mm": 0,
                 *       "z_mm": 130,
                 *       "rotation_deg": 0
                 *     }
                 */
                "application/json": components["schemas"]["Place"];
            };
        };
        responses: {
            /** @description what it would be near to, by 20 mm or 5 degrees */
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
             * @description - `policy`: the policy does not allow this
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
    post_jog_step: {
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
                 *       "button": {
                 *         "frame": "linear",
                 *         "axis": "x_plus"
                 *       },
                 *       "by": 1
                 *     }
                 */
                "application/json": components["schemas"]["NewStep"];
            };
        };
        responses: {
            /** @description the step waits for its turn */
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
            /**
             * @description - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
    post_lock: {
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
                 *       "message": "eyes on me"
                 *     }
                 */
                "application/json": components["schemas"]["NewLock"];
            };
        };
        responses: {
            /** @description the arm is locked */
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
    delete_lock: {
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
            /** @description the arm is not locked */
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
    get_slots: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the slots */
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
    put_slots: {
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
                 *       "slots": [
                 *         {
                 *           "student": "Anna",
                 *           "starts_in_s": 0,
                 *           "ends_in_s": 900
                 *         },
                 *         {
                 *           "student": "Ben",
                 *           "group": "red",
                 *           "starts_in_s": 900,
                 *           "ends_in_s": 1800
                 *         }
                 *       ]
                 *     }
                 */
                "application/json": components["schemas"]["NewSlots"];
            };
        };
        responses: {
            /** @description the slots */
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
             * @description - `bad-slots`: the time slots cannot be so
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
    delete_slots: {
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
            /** @description there are none */
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
    post_message: {
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
                 *       "text": "five more minutes"
                 *     }
                 */
                "application/json": components["schemas"]["NewMessage"];
            };
        };
        responses: {
            /** @description it is told */
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
    get_learners: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the students */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["LearnerView"][];
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
    post_learners: {
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
                 *       "student": "Anna",
                 *       "lesson": "tour",
                 *       "done": 2,
                 *       "steps": 12
                 *     }
                 */
                "application/json": components["schemas"]["Progress"];
            };
        };
        responses: {
            /** @description it is told */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["LearnerView"];
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
             * @description - `role`: the role does not allow this
             *     - `forbidden-host`: the station does not go by this name
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
    get_calibration: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description what is known */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Calibrations"];
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
    put_calibration: {
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
                 *       "calibration": {
                 *         "zeros": {
                 *           "base": 1.5,
                 *           "rear": -4.2,
                 *           "fore": 3.1
                 *         },
                 *         "tool": {
                 *           "out_mm": 2,
                 *           "left_mm": 0.5
                 *         }
                 *       }
                 *     }
                 */
                "application/json": components["schemas"]["NewCalibration"];
            };
        };
        responses: {
            /** @description what is known now */
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
             * @description - `job-running`: a job has the arm
             *     - `detecting`: the arm is finding out its dialect
             *     - `still-moving`: the arm still moves
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
    post_calibration_angles: {
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
            /** @description the command is accepted */
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
    post_calibration_fit: {
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
                 *       "bar_mm": 200,
                 *       "touches": [
                 *         {
                 *           "place_mm": [
                 *             215,
                 *             0
                 *           ],
                 *           "told_deg": [
                 *             0,
                 *             35.1,
                 *             47.2
                 *           ]
                 *         },
                 *         {
                 *           "place_mm": [
                 *             155,
                 *             100
                 *           ],
                 *           "told_deg": [
                 *             32.8,
                 *             20.4,
                 *             51
                 *           ]
                 *         },
                 *         {
                 *           "place_mm": [
                 *             275,
                 *             100
                 *           ],
                 *           "told_deg": [
                 *             20,
                 *             58.6,
                 *             40.3
                 *           ]
                 *         },
                 *         {
                 *           "place_mm": [
                 *             275,
                 *             -100
                 *           ],
                 *           "told_deg": [
                 *             -20,
                 *             58.6,
                 *             40.3
                 *           ]
                 *         }
                 *       ]
                 *     }
                 */
                "application/json": components["schemas"]["NewTouches"];
            };
        };
        responses: {
            /** @description what they tell */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FitReport"];
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
             * @description - `bad-touches`: the touches tell no calibration
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
    post_calibration_paper: {
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
                 *       "places_mm": [
                 *         [
                 *           160,
                 *           -80,
                 *           -42.1
                 *         ],
                 *         [
                 *           160,
                 *           80,
                 *           -41.6
                 *         ],
                 *         [
                 *           270,
                 *           0,
                 *           -43
                 *         ]
                 *       ]
                 *     }
                 */
                "application/json": components["schemas"]["PaperTouches"];
            };
        };
        responses: {
            /** @description how it lies */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PaperReport"];
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
             * @description - `bad-touches`: the touches tell no calibration
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
    post_calibration_picture: {
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
                 *       "bar_mm": 200,
                 *       "touches": [
                 *         {
                 *           "place_mm": [
                 *             215,
                 *             0
                 *           ],
                 *           "told_deg": [
                 *             0,
                 *             35.1,
                 *             47.2
                 *           ]
                 *         },
                 *         {
                 *           "place_mm": [
                 *             155,
                 *             100
                 *           ],
                 *           "told_deg": [
                 *             32.8,
                 *             20.4,
                 *             51
                 *           ]
                 *         },
                 *         {
                 *           "place_mm": [
                 *             275,
                 *             100
                 *           ],
                 *           "told_deg": [
                 *             20,
                 *             58.6,
                 *             40.3
                 *           ]
                 *         },
                 *         {
                 *           "place_mm": [
                 *             275,
                 *             -100
                 *           ],
                 *           "told_deg": [
                 *             -20,
                 *             58.6,
                 *             40.3
                 *           ]
                 *         }
                 *       ]
                 *     }
                 */
                "application/json": components["schemas"]["NewTouches"];
            };
        };
        responses: {
            /** @description the sheet with the touches */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "image/svg+xml": string;
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
             * @description - `bad-touches`: the touches tell no calibration
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
    get_calibration_points: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the points */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SheetPoints"];
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
    get_calibration_sheet: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the sheet */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "image/svg+xml": string;
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
    get_jobs: {
        parameters: {
            query?: {
                /** @description How many at the most, 1 to 1000; without it all */
                limit?: number;
                /** @description The number or name of the last one of the page before; the header Link has the address of the next page */
                after?: string;
            };
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
            /** @description - `out-of-range`: a number is not allowed */
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
    post_jobs: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
                /** @description What the sender calls this request: sent again with the same key it queues no other job, and names the one that is there */
                "Idempotency-Key"?: string;
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
            /** @description the job is queued; the header Location names it */
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
             * @description - `key-reused`: the key was that of another request
             *     - `bad-job`: the job cannot be done
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
    get_jobs_id_path: {
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
            /** @description the way */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobPath"];
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
            /** @description - `bad-job`: the job cannot be done */
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
    post_jobs_id_again: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
                /** @description What the sender calls this request: sent again with the same key it queues no other job, and names the one that is there */
                "Idempotency-Key"?: string;
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
            /** @description the job is queued; the header Location names it */
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
             * @description - `key-reused`: the key was that of another request
             *     - `bad-job`: the job cannot be done
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
    put_jobs_id_place: {
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
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "before": 3
                 *     }
                 */
                "application/json": components["schemas"]["Place2"];
            };
        };
        responses: {
            /** @description the job has its place */
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
             * @description - `job-phase`: the job does not allow this now
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
    post_jobs_id_forget: {
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
            /** @description the job is forgotten */
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
             * @description - `job-phase`: the job does not allow this now
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm still moves
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job has the arm
             *     - `detecting`: the arm is finding out its dialect
             *     - `job-phase`: the job does not allow this now
             *     - `cannot-resume`: the job cannot be gone on with
             *     - `needs-a-person`: a person has to confirm this
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
    post_jobs_id_confirm: {
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
            /** @description the job may go on */
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm still moves
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job has the arm
             *     - `detecting`: the arm is finding out its dialect
             *     - `job-phase`: the job does not allow this now
             *     - `cannot-resume`: the job cannot be gone on with
             *     - `needs-a-person`: a person has to confirm this
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
             *     - `locked`: the arm is locked
             *     - `slot`: it is the time of somebody else
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
    post_programs_check: {
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
                 *       "text": "title = \"there\"\n\n[[steps]]\ngo = { x = 200, y = 0, z = 50 }\n"
                 *     }
                 */
                "application/json": components["schemas"]["ProgramText"];
            };
        };
        responses: {
            /** @description what was found; a program with problems is answered so, too */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProgramReport"];
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
    post_programs_edit: {
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
                 *       "text": "[[steps]]\ngo = { x = 200, y = 0, z = 50 }\n",
                 *       "edits": [
                 *         {
                 *           "type": "insert",
                 *           "at": 1,
                 *           "step": {
                 *             "suction": true,
                 *             "pause": 0.5
                 *           }
                 *         }
                 *       ]
                 *     }
                 */
                "application/json": components["schemas"]["EditProgram"];
            };
        };
        responses: {
            /** @description the text */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["EditedProgram"];
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
             * @description - `bad-program`: the program cannot be done
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
    post_programs_convert: {
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
                 *       "text": "[[steps]]\ngo = { base = 0, rear = 40, fore = 45 }\n",
                 *       "to": "xml"
                 *     }
                 */
                "application/json": components["schemas"]["ConvertProgram"];
            };
        };
        responses: {
            /** @description the text */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ConvertedProgram"];
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
             * @description - `bad-program`: the program cannot be done
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
    post_programs_jobs: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
                /** @description What the sender calls this request: sent again with the same key it queues no other job, and names the one that is there */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 65536 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "program": {
                 *         "text": "title = \"there\"\n\n[[steps]]\ngo = { x = 200, y = 0, z = 50 }\n"
                 *       },
                 *       "times": {
                 *         "count": 3
                 *       }
                 *     }
                 */
                "application/json": components["schemas"]["NewProgram"];
            };
        };
        responses: {
            /** @description the job is queued; the header Location names it */
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
             * @description - `key-reused`: the key was that of another request
             *     - `bad-program`: the program cannot be done
             *     - `bad-job`: the job cannot be done
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
    get_recordings: {
        parameters: {
            query?: {
                /** @description How many at the most, 1 to 1000; without it all */
                limit?: number;
                /** @description The number or name of the last one of the page before; the header Link has the address of the next page */
                after?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the recordings */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RecordingView"][];
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
            /** @description - `out-of-range`: a number is not allowed */
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
            /** @description - `recording`: the recordings cannot be read */
            500: {
                headers: {
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
    get_recordings_name: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the file */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": string;
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
            /** @description - `no-such-recording`: there is no such recording */
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
            /** @description - `recording`: the recordings cannot be read */
            500: {
                headers: {
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
    get_recordings_name_states: {
        parameters: {
            query?: {
                /** @description From when on, in seconds since the times of the recording begin; 0 without it */
                from_s?: number;
                /** @description Until when; without it to the end */
                to_s?: number;
                /** @description How many samples at the most, 2 to 5000; 2000 without it */
                most?: number;
            };
            header?: never;
            path: {
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description where the arm was */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RecordedStates"];
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
            /** @description - `no-such-recording`: there is no such recording */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `out-of-range`: a number is not allowed */
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
            /** @description - `recording`: the recordings cannot be read */
            500: {
                headers: {
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
    post_drawings: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 32768 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "options": {
                 *         "what": {
                 *           "text": "Hello"
                 *         },
                 *         "place": {
                 *           "at": [
                 *             210,
                 *             0
                 *           ],
                 *           "pen_down": -40
                 *         }
                 *       }
                 *     }
                 */
                "application/json": components["schemas"]["NewDrawing"];
            };
        };
        responses: {
            /** @description it is being planned; the header Location names it */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DrawingView"];
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
             * @description - `bad-drawing`: it cannot be drawn
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
        };
    };
    get_drawings_id: {
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
            /** @description the drawing */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DrawingView"];
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
            /** @description - `no-such-drawing`: there is no such drawing */
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
    delete_drawings_id: {
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
            /** @description it is forgotten */
            204: {
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
            /** @description - `no-such-drawing`: there is no such drawing */
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
    post_drawings_id_jobs: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
                /** @description What the sender calls this request: sent again with the same key it queues no other job, and names the one that is there */
                "Idempotency-Key"?: string;
            };
            path: {
                id: number;
            };
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody?: {
            content: {
                /**
                 * @example {
                 *       "part": "whole"
                 *     }
                 */
                "application/json": components["schemas"]["DrawingJob"];
            };
        };
        responses: {
            /** @description the job is queued; the header Location names it */
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
            /** @description - `no-such-drawing`: there is no such drawing */
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
             * @description - `drawing-phase`: the drawing is not planned yet
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
             * @description - `key-reused`: the key was that of another request
             *     - `bad-drawing`: it cannot be drawn
             *     - `bad-job`: the job cannot be done
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
    get_materials: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the pens and materials */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MaterialView"][];
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
    get_formats: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the formats */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Format"][];
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
    get_tokens: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the tokens */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TokenView"][];
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
            /** @description - `token-file`: the tokens cannot be read or written */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_tokens: {
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
                 *       "name": "phone",
                 *       "role": "control"
                 *     }
                 */
                "application/json": components["schemas"]["TokenView"];
            };
        };
        responses: {
            /** @description the token */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["NewToken"];
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
             * @description - `token-taken`: another token has this name
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
             * @description - `token-name`: no token can have this name
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
            /** @description - `token-file`: the tokens cannot be read or written */
            500: {
                headers: {
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
    delete_tokens_name: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the tokens that are left */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TokenView"][];
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
            /** @description - `no-such-token`: there is no such token */
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
            /** @description - `token-file`: the tokens cannot be read or written */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_world: {
        parameters: {
            query?: {
                /** @description Of ink and burns only those from this one on, counted from 0; the last one may still grow */
                strokes_from?: number;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the world */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WorldState"];
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
            /** @description - `not-virtual`: the arm is no virtual one of this station */
            409: {
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
    put_world: {
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
                 *       "scene": "[pen]\ndown_z_mm = -40\n"
                 *     }
                 */
                "application/json": components["schemas"]["SceneText"];
            };
        };
        responses: {
            /** @description the world */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WorldState"];
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
             * @description - `not-virtual`: the arm is no virtual one of this station
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
             * @description - `bad-scene`: the text is no scene
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
    get_faults: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the faults */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": string[];
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
            /** @description - `not-virtual`: the arm is no virtual one of this station */
            409: {
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
    put_faults: {
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
                 *       "faults": [
                 *         "drop=1%",
                 *         "reset@3s"
                 *       ],
                 *       "seed": 1
                 *     }
                 */
                "application/json": components["schemas"]["NewFaults"];
            };
        };
        responses: {
            /** @description the faults */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": string[];
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
             * @description - `not-virtual`: the arm is no virtual one of this station
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
             * @description - `bad-fault`: that cannot go wrong so
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
    get_fleet: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the fleet */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FleetView"];
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
            /** @description - `no-fleet`: this station belongs to no fleet */
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
    get_fleet_events: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the events */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": components["schemas"]["ServerSentEvent"];
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
            /** @description - `no-fleet`: this station belongs to no fleet */
            404: {
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
    post_fleet_stop: {
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
                 *       "to": {
                 *         "group": "room-2"
                 *       },
                 *       "reason": "smoke"
                 *     }
                 */
                "application/json": components["schemas"]["FleetStop"];
            };
        };
        responses: {
            /** @description the answer of each */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MemberAnswer"][];
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
            /**
             * @description - `no-fleet`: this station belongs to no fleet
             *     - `no-such-member`: the fleet has no such station
             */
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
    delete_fleet_stop: {
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
            /** @description which stations know of it */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MemberAnswer"][];
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
             * @description - `role`: the role does not allow this
             *     - `forbidden-host`: the station does not go by this name
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
            /** @description - `no-fleet`: this station belongs to no fleet */
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
    post_fleet_requests: {
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
                 *       "to": {
                 *         "members": [
                 *           "desk-3"
                 *         ]
                 *       },
                 *       "method": "GET",
                 *       "path": "/api/v1/jobs"
                 *     }
                 */
                "application/json": components["schemas"]["FleetRequest"];
            };
        };
        responses: {
            /** @description the answer of each */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MemberAnswer"][];
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
            /**
             * @description - `no-fleet`: this station belongs to no fleet
             *     - `no-such-member`: the fleet has no such station
             */
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
    get_fleet_work: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the work */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WorkView"][];
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
             * @description - `role`: the role does not allow this
             *     - `forbidden-host`: the station does not go by this name
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
            /** @description - `no-fleet`: this station belongs to no fleet */
            404: {
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
    post_fleet_work: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
                /** @description What the sender calls this request: sent again with the same key it queues no other job, and names the one that is there */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 65536 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "drawing": {
                 *         "options": {
                 *           "what": {
                 *             "text": "Hello"
                 *           },
                 *           "place": {
                 *             "at": [
                 *               210,
                 *               0
                 *             ],
                 *             "pen_down": -40
                 *           }
                 *         }
                 *       },
                 *       "needs": [
                 *         "pen",
                 *         "a5"
                 *       ],
                 *       "student": "Anna"
                 *     }
                 */
                "application/json": components["schemas"]["FleetWork"];
            };
        };
        responses: {
            /** @description it waits for an arm */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WorkView"];
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
             * @description - `role`: the role does not allow this
             *     - `forbidden-host`: the station does not go by this name
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
            /** @description - `no-fleet`: this station belongs to no fleet */
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
            /** @description - `work-file`: the work cannot be written */
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
    delete_fleet_work_work: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                work: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description it is cancelled, or is being withdrawn */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WorkView"];
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
             * @description - `role`: the role does not allow this
             *     - `forbidden-host`: the station does not go by this name
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
            /**
             * @description - `no-fleet`: this station belongs to no fleet
             *     - `no-such-work`: there is no such work
             */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `work-phase`: this cannot be done with it now */
            409: {
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
    post_fleet_work_work_give: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                work: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description it waits for another arm */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WorkView"];
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
             * @description - `role`: the role does not allow this
             *     - `forbidden-host`: the station does not go by this name
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
            /**
             * @description - `no-fleet`: this station belongs to no fleet
             *     - `no-such-work`: there is no such work
             */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `work-phase`: this cannot be done with it now */
            409: {
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
    post_fleet_offers: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
                /** @description What the sender calls this request: sent again with the same key it queues no other job, and names the one that is there */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description Up to 65536 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "by": "desk-1",
                 *       "student": "Anna",
                 *       "drawing": {
                 *         "options": {
                 *           "what": {
                 *             "text": "Hello"
                 *           },
                 *           "place": {
                 *             "at": [
                 *               210,
                 *               0
                 *             ],
                 *             "pen_down": -40
                 *           }
                 *         }
                 *       }
                 *     }
                 */
                "application/json": components["schemas"]["FleetOffer"];
            };
        };
        responses: {
            /** @description it is taken: the job */
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
            /** @description - `no-fleet`: this station belongs to no fleet */
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
             * @description - `arm-busy`: the arm has other work
             *     - `work-refused`: the station does not take this work
             *     - `drawing-phase`: the drawing is not planned yet
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
    get_fleet_offers_key: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                key: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description it was taken: the job as it is now */
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
            /** @description - `no-such-work`: there is no such work */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `arm-busy`: the arm has other work
             *     - `work-refused`: the station does not take this work
             */
            409: {
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
    delete_fleet_offers_key: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                key: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description it was taken before: the job as it is now */
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
            /** @description - `no-such-work`: there is no such work */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `arm-busy`: the arm has other work
             *     - `work-refused`: the station does not take this work
             */
            409: {
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
    "get_fleet_virtual-arms": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the virtual arms */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GivenArms"];
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
             * @description - `role`: the role does not allow this
             *     - `forbidden-host`: the station does not go by this name
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
            /** @description - `gives-no-arms`: this station gives no virtual arms */
            409: {
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
    "post_fleet_virtual-arms": {
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
                 *       "name": "anna"
                 *     }
                 */
                "application/json": components["schemas"]["WantedVirtualArm"];
            };
        };
        responses: {
            /** @description the virtual arm */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GivenArm"];
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
             * @description - `role`: the role does not allow this
             *     - `forbidden-host`: the station does not go by this name
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
            /** @description - `no-fleet`: this station belongs to no fleet */
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
             * @description - `gives-no-arms`: this station gives no virtual arms
             *     - `name-taken`: another station has this name
             *     - `all-arms-given`: all virtual arms are given
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
            /** @description - `arm-not-started`: the virtual arm cannot be started */
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
    "delete_fleet_virtual-arms_name": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description those that are left */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GivenArms"];
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
             * @description - `role`: the role does not allow this
             *     - `forbidden-host`: the station does not go by this name
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
            /** @description - `no-such-arm`: there is no such virtual arm */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `gives-no-arms`: this station gives no virtual arms */
            409: {
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
    get_mcp: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description messages of the protocol */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": string;
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
            /**
             * @description - `not-built`: the station is built without this
             *     - `unknown-path`: there is nothing at this address
             */
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
        };
    };
    post_mcp: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description messages of the protocol */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": string;
                };
            };
            /** @description the message is taken, and nothing is answered to it */
            202: {
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
            /**
             * @description - `not-built`: the station is built without this
             *     - `unknown-path`: there is nothing at this address
             */
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
        };
    };
    delete_mcp: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description messages of the protocol */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": string;
                };
            };
            /** @description the session is over */
            202: {
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
            /**
             * @description - `not-built`: the station is built without this
             *     - `unknown-path`: there is nothing at this address
             */
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
        };
    };
}
