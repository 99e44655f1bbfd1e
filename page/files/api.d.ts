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
        /** Explains a problem type */
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
        /** The state of the station */
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
        /** The facts of the arm: its lengths, tools, limits and periods, and the meaning of mouse and gesture packets in its dialect. They change with the policy and the dialect */
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
        /** The latest notices, the oldest first */
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
        /** The safety policy, as shown by `dobot policy` */
        get: operations["get_policy"];
        /** Replaces and stores the safety policy; the arm must be idle. With `check` the text is only validated */
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
        /** The safety policy as a TOML text, with its comments if it came from a file */
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
        /** Adds, replaces or removes a keep-out zone in the text of a draft; the rest keeps its comments and its format, and the active policy is unchanged */
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
        /** Whether the station is alive, for a supervisor that restarts it; the arm may be disconnected */
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
        /** The metrics of arm, link, queue, laser and job, for Prometheus */
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
        /** States and notices as server-sent events: `state` and `notice`, each with a message as in `ToClient`. A notice has its number as its id; with `Last-Event-ID` the missed ones are sent first, as far as the station has kept them. */
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
        /** All packets between the station and the arm, in both directions and decoded, from now on, as server-sent events: `packet`, or `lost` with the number of packets that were dropped because the client was too slow */
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
        /** Sends one command, if the policy allows its whole path */
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
        /** Checks where a command would lead if it were sent now, or why it would be refused; nothing is sent */
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
        /** Returns the limits and keep-out zones near a position; nothing is sent */
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
        /** Holds a jog button; it is released unless this request is repeated within the dead-man time (150 ms by default) */
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
        /** Moves by one step of a jog button, from the position after all previous commands; pump and gripper do not change */
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
        /** Resets a stop, after a person has checked the arm */
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
        /** Takes control if it is free; with a lease token, renews the lease */
        post: operations["post_lease"];
        /** Releases control */
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
        /** Asks the lease holder for control; the state shows when it is granted */
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
        /** Grants control to a client that asked for it */
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
        /** Takes control from the lease holder (admin) */
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
        /** Locks the arm for administrators (admin): any other lease ends, and a running job is paused */
        post: operations["post_lock"];
        /** Unlocks the arm (admin) */
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
        /** All current and future time slots, in order */
        get: operations["get_slots"];
        /** Replaces the time slots (admin): during a slot only its student and administrators can take control */
        put: operations["put_slots"];
        post?: never;
        /** Removes all time slots (admin) */
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
        /** Sends a message to all observers */
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
        /** The students in lessons that were reported within a minute, by name, with the time at their steps */
        get: operations["get_learners"];
        put?: never;
        /** Reports the progress of a student in a lesson, for the board of the fleet. It expires after a minute unless it is repeated */
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
        /** Arms the laser for a while: everyone present must wear goggles */
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
        /** Confirms that the arm is where its statuses report, after a person has checked */
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
        /** Sets the dialect of the arm (admin) */
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
        /** Detects the dialect of the arm with small slow motions */
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
        /** The calibration of the arm, and the previous one */
        get: operations["get_calibration"];
        /** Sets the calibration of the arm: from then on all positions are calibrated. It is stored for this arm together with the previous one; `null` selects the nominal dimensions (admin) */
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
        /** Sends a calibrated arm its true joint angles (state 9, mode 3), which corrects its zeros until its next reset. The arm must be at rest, with its base straight ahead */
        post: operations["post_calibration_angles"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/calibration/bar": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Checks the measured length of the bar on a printed sheet */
        post: operations["post_calibration_bar"];
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
        /** Fits a calibration to touches of the sheet: returns its residuals, whether to trust it, and the most useful further point. Nothing is stored */
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
        /** Fits the paper to touches at calibrated positions: three give its plane, more its curvature. Nothing is stored: add the result to the calibration */
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
        /** The residuals of touches of the sheet, as a picture */
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
        /** The points of the sheet, in the order of touching */
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
        /** A sheet to print, A4 landscape, at 100 %: each time another one, with its own number and a bar to measure */
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
        /** The planned path of a job, once through its commands */
        get: operations["get_jobs_id_path"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/sketch": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A small picture of what a job draws, or of its path; null if it does not move */
        get: operations["get_jobs_id_sketch"];
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
        /** Queues a copy of a job, as a new job that is planned again */
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
        /** Moves a queued job before another one, or to the end */
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
        /** Deletes a job that has ended, or that has not begun */
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
        /** Starts a queued job, or resumes a paused one */
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
        /** Confirms that a person has done what a paused job waits for; then resume it */
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
        /** Runs the next step of a queued or paused job, and pauses after it */
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
        /** Pauses the running job after the in-flight commands */
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
        /** Changes the drawing speed of the job, from the next unsent vector on */
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
        /** Changes the drawing height of the job, gradually, from the next unsent command on */
        put: operations["put_jobs_height"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/answer": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Answers the question of the running program, which continues with the steps of the answer */
        post: operations["post_jobs_id_answer"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/places/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /** Gives the running program the position that it waits for, if the policy allows it */
        put: operations["put_jobs_id_places_name"];
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
        /** Checks a whole program: its steps, their durations, and all problems */
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
        /** Edits the text of a program; unchanged parts keep their comments and their format */
        post: operations["post_programs_edit"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/merge": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Puts the content of another program into a text; unchanged keys and steps keep their comments and their format, also steps that were moved */
        post: operations["post_programs_merge"];
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
        /** Converts a file of the vendor's software (`PlayBackPoints.xml`, `.play`) into the text of a program, or the text into such a file; reports what the target format cannot represent */
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
        /** Queues a program as a job, unless it has problems */
        post: operations["post_programs_jobs"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/buttons": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The buttons that people have added to the page */
        get: operations["get_buttons"];
        put?: never;
        /** Adds a button to all pages of the station */
        post: operations["post_buttons"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/buttons/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** Removes a button from all pages of the station */
        delete: operations["delete_buttons_name"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/talk": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Whether a listener runs next to the station, so that orders can be spoken */
        get: operations["get_talk"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/talk/audio": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** For a listener: the audio that clients have sent as binary WebSocket messages since the last request; waits up to a second for some. What it understands it sends as a request `heard` */
        get: operations["get_talk_audio"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/episodes": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Marks the recording: an episode of a dataset begins or ends here, or is discarded */
        post: operations["post_episodes"];
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
        /** A recording, as an MCAP file; of one that is being written the part so far */
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
        /** The positions of the arm over a part of a recording; of a long one not all statuses */
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
        /** Starts to plan a file or a text as a drawing; the 16 latest are kept */
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
        /** A drawing, as soon as it is planned, or its state after a second */
        get: operations["get_drawings_id"];
        put?: never;
        post?: never;
        /** Deletes a drawing; a running plan is cancelled */
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
        /** Queues a planned drawing as a job, or its outline with the laser off */
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
        /** The pens and materials for drawings */
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
        /** The supported file formats */
        get: operations["get_formats"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/files": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The stored drawings, photos and programs, and their space */
        get: operations["get_files"];
        put?: never;
        /** Stores a file */
        post: operations["post_files"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/files/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A stored file */
        get: operations["get_files_id"];
        /** Changes name, content or options of a stored file */
        put: operations["put_files_id"];
        post?: never;
        /** Deletes a stored file */
        delete: operations["delete_files_id"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/files/{id}/content": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The content of a stored file */
        get: operations["get_files_id_content"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/files/{id}/sketch": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A small picture of a stored drawing or photo; null until it is made */
        get: operations["get_files_id_sketch"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/extras": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The optional parts of the page that are installed (`dobot extras`) */
        get: operations["get_extras"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/extras/{extra}/{file}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A file of an optional part of the page */
        get: operations["get_extras_extra_file"];
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
        /** Creates a token, whose secret is shown only now; for administrators */
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
        /** Removes a token: its holder loses access; for administrators */
        delete: operations["delete_tokens_name"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/addresses": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The addresses at which other devices in the network reach the page; none if the station listens on this computer only */
        get: operations["get_addresses"];
        put?: never;
        post?: never;
        delete?: never;
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
        /** The world of the station's own virtual arm: tool, paper, ink, objects */
        get: operations["get_world"];
        /** Replaces the world of the station's own virtual arm; the arm keeps its pose */
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
        /** The faults of the station's own virtual arm */
        get: operations["get_faults"];
        /** Replaces the faults of the station's own virtual arm */
        put: operations["put_faults"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/virtual-arms": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The virtual arms that were started for tests */
        get: operations["get_virtual-arms"];
        put?: never;
        /** Starts a virtual arm for the test of a program, on a TCP port of its own. It ends when its client leaves, on DELETE, or if nobody connects within a minute */
        post: operations["post_virtual-arms"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/virtual-arms/{arm}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** Ends a virtual arm that was started for a test */
        delete: operations["delete_virtual-arms_arm"];
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
        /** All known stations of the fleet */
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
        /** The stations of the fleet as server-sent events: `member`, each with a message as in `Member`, first for all stations, then for each change, at most ten times per second; and `gone` with the id of a station that is not listed any more, as in `{"id": "..."}`: a hosted virtual arm that has ended, or a station that was replaced under its name */
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
        /** Stops the arms of several stations, by default of all; anyone may. The response shows which did not respond: stop those on their own pages. A stop of all is kept by every station, and applies to those that join or return, until a person resets it */
        post: operations["post_fleet_stop"];
        /** Resets a stop of all stations; an arm that was also stopped individually stays stopped. A station that is away learns of it when it returns. For one arm only: `DELETE /api/v1/stop` of its station */
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
        /** Sends a request to several stations: method, path and body are those of their own API. The token of this request is used, and each station checks its role */
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
        /** All jobs for any arm that were submitted to this station, in order */
        get: operations["get_fleet_work"];
        put?: never;
        /** Submits a drawing or a job to any arm of the fleet with the required features: a free one runs it, once */
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
        /** Cancels a job for any arm, unless the arm has begun it */
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
        /** Moves a job that is in doubt or has failed to another arm. A person must have checked the first one: parts that were drawn there may be drawn again */
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
        /** Accepts a job of the fleet under a key, if no other job is queued or running here. The response to a key is final: a repeated request returns the same job, and a refused one never runs */
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
        /** The state of a job that was offered under a key */
        get: operations["get_fleet_offers_key"];
        put?: never;
        post?: never;
        /** Withdraws an offer: it is refused even if it arrives later, and its job ends if it has not begun */
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
        /** The virtual arms that this station hosts */
        get: operations["get_fleet_virtual-arms"];
        put?: never;
        /** Starts a virtual arm: a station of the fleet with its own page, which accepts the tokens of this one. A repeated request for the same name returns the same arm, with its jobs and recordings */
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
        /** Ends a virtual arm; its jobs and recordings are kept for the next one of its name */
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
        /** Messages of the server to an agent, as server-sent events */
        get: operations["get_mcp"];
        put?: never;
        /** A message of an agent (Model Context Protocol, streamable HTTP): each tool uses the token of the request. Closing the connection before the response cancels the call, and the arm is stopped if the call has moved it. */
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
            /** @description The problem type; its URL explains it. */
            type: string;
            /** @description The problem type in words. */
            title: string;
            /**
             * Format: uint16
             * @description The HTTP status.
             */
            status: number;
            /** @description What is wrong: where, what was found and what is allowed. */
            detail: string;
            /** @description How to fix it. */
            hint?: string | null;
            /** @description The policy rule that was broken. */
            rule?: string | null;
            /** @description Where the motion would break the rule: x, y and z in millimetres. */
            at_mm?: number[] | null;
            /** @description The nearest allowed position: x, y and z in millimetres. */
            nearest_mm?: number[] | null;
        };
        /** @description A problem type with its explanation. */
        ProblemKind: {
            /** @description The name: the last part of the problem type's URL. */
            kind: string;
            /** @description The problem in words. */
            title: string;
            /**
             * Format: uint16
             * @description The HTTP status.
             */
            status: number;
            /** @description The meaning and the remedy. */
            explanation: string;
        };
        /** @description The state of the station at one moment. */
        State: {
            /**
             * Format: double
             * @description The time since the station started, in seconds.
             */
            at_s: number;
            /** @description The link to the arm. */
            link: components["schemas"]["LinkView"];
            /** @description The arm's last status; absent until one has arrived. */
            arm?: components["schemas"]["ArmView"] | null;
            /** @description The calibration used for positions, if the arm has one. */
            calibrated?: components["schemas"]["CalibratedView"] | null;
            /** @description The dialect that the arm speaks, if known. */
            dialect?: components["schemas"]["Dialect"] | null;
            /**
             * @description The commands that give the arm's current settings (speeds, heights, pauses and tool) to an
             *     arm that was just switched on; absent if it has the settings of power-up.
             */
            settings?: components["schemas"]["Command"][];
            /** @description Whether the pose can be trusted. */
            trust: components["schemas"]["TrustView"];
            /** @description The command queue. */
            queue: components["schemas"]["QueueView"];
            /** @description The lease holder, if any. */
            lease?: components["schemas"]["LeaseView"] | null;
            /** @description The administrators' lock, if any. */
            lock?: components["schemas"]["LockView"] | null;
            /** @description The current and next time slot, if the arm has any. */
            slots?: components["schemas"]["SlotsView"] | null;
            /** @description The stop that holds the arm, if any. */
            stop?: components["schemas"]["StopView"] | null;
            /**
             * @description The known fleet-wide stops, at most one per station of origin. Stops that were reset are
             *     kept for stations that return and do not know it yet.
             */
            fleet_stops?: components["schemas"]["FleetWideStop"][];
            /** @description The laser's interlock. */
            laser: components["schemas"]["LaserView"];
            /** @description The running or paused job. */
            job?: components["schemas"]["JobView"] | null;
            /** @description What is missing of the stored jobs and what to do, if their file was damaged. */
            jobs_missing?: string | null;
            /**
             * Format: uint
             * @description The number of connected clients.
             */
            clients: number;
        };
        /** @description The link to the arm. */
        LinkView: {
            /** @description The address of the arm; absent if there is none yet. */
            address?: string | null;
            /** @description The phase of the link. */
            phase: components["schemas"]["LinkPhase"];
            /** @description What is wrong, if anything. */
            problem?: string | null;
            /** @description Its kind, for programs. */
            cause?: components["schemas"]["LinkCause"] | null;
            /** @description What to do about it. */
            remedy?: string | null;
            /**
             * @description Whether the link uses the Bluetooth port of a stock arm, as detected from its statuses. Its
             *     joint jogs have other axes, to which jogs are translated.
             * @default false
             */
            bluetooth: boolean;
            /**
             * Format: double
             * @description Statuses per second; nominally 12.5, or 18.75 over Bluetooth.
             */
            statuses_per_s: number;
            /**
             * Format: uint64
             * @description Missing statuses since the link was opened.
             */
            lost_statuses: number;
            /**
             * Format: uint64
             * @description Bytes that belong to no status, since the link was opened.
             */
            damaged_bytes: number;
            /**
             * Format: double
             * @description The time from a command to the first status that shows it, in milliseconds, if known.
             */
            latency_ms?: number | null;
        };
        /** @description The phase of the link. */
        LinkPhase: "searching" | "listening" | "up" | "lost";
        /** @description The kinds of reasons why there is no link to an arm. */
        LinkCause: "none_found" | "no_such_port" | "not_allowed" | "in_use" | "not_a_serial_port" | "unreachable" | "cannot_open" | "silent" | "not_an_arm" | "big_endian" | "closed" | "broken";
        /** @description The arm's last status. */
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
            /** @description The raw status of a calibrated arm. */
            raw?: components["schemas"]["Status"] | null;
            /**
             * @description Whether the arm moves or may still move; otherwise it is at rest: no command waits or is in flight, no
             *     button is held, and the last statuses are equal.
             */
            moving: boolean;
            /** @description Why the pose may not be recorded as a touch of a calibration: a joint came from the other side. */
            touch_refused?: string | null;
            /** @description The policy limits and keep-outs close to the arm. */
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
         * @description The policy limits and keep-outs close to the arm.
         *
         *     Each closeness is above 0 (20 mm or 5 degrees away) and reaches 1 at the bound or beyond it.
         */
        NearView: {
            /** @description The joint and workspace bounds. */
            limits?: components["schemas"]["NearLimit"][];
            /** @description The closeness of the tool to keep-outs, by name. */
            keep_outs?: {
                [key: string]: number;
            };
        };
        /** @description A bound close to the arm. */
        NearLimit: {
            /** @description The bounded quantity. */
            quantity: components["schemas"]["BoundedQuantity"];
            /**
             * Format: double
             * @description The bound, in degrees or mm.
             */
            bound: number;
            /**
             * Format: double
             * @description The closeness: above 0, and 1 at the bound or beyond it.
             */
            closeness: number;
        };
        /** @description A quantity that the policy bounds. */
        BoundedQuantity: "base" | "rear" | "fore" | "servo" | "opening" | "x" | "y" | "z" | "reach";
        /** @description The calibration used for positions. */
        CalibratedView: {
            /**
             * @description Whether the arm was given its true angles (state 9, mode 3) since it was switched on: then
             *     only its tool is offset from what it reports.
             */
            angles_set: boolean;
        };
        /**
         * @description What the packets mean: as the published document says, or as stock arms do (firmware 1.1).
         * @enum {string}
         */
        Dialect: "specification" | "firmware-1.1";
        /** @description A command from a client (Table 2.2). */
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
            /** @description The axis or switch of the button. */
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
            /** @description The axis or switch of the button. */
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
        /** @description The axis or switch of a joint jog button (Table 2.5; note N14). */
        JointJogAxis: "released" | "base_plus" | "base_minus" | "rear_plus" | "rear_minus" | "fore_plus" | "fore_minus" | "servo_plus" | "servo_minus" | "suction_on" | "suction_off" | "gripper_open" | "gripper_close" | "laser_on" | "laser_off";
        /** @description The way to a target (float 8 of states 3 and 6; Table 3.7). */
        MovingMode: "jump" | "movl" | "movj";
        /** @description Pen or laser (float 2 of state 4; Table 2.6). */
        WriteMode: "writing" | "laser";
        /** @description The axis or switch of a linear jog button (Table 2.5; note N14). */
        LinearJogAxis: "released" | "x_plus" | "x_minus" | "y_plus" | "y_minus" | "z_plus" | "z_minus" | "servo_plus" | "servo_minus" | "suction_on" | "suction_off" | "gripper_open" | "gripper_close" | "laser_on" | "laser_off";
        /** @description The tool mounted at the end of the arm. */
        Tool: "suction_cup" | "gripper" | "pen" | "laser";
        /** @description Whether the pose can be trusted. */
        TrustView: {
            /** @description Whether it can. */
            trusted: boolean;
            /** @description The reason if not. */
            reason?: string | null;
        };
        /** @description The command queue. */
        QueueView: {
            /**
             * Format: uint
             * @description Commands waiting in the station.
             */
            waiting: number;
            /**
             * Format: uint
             * @description In-flight commands: sent and not yet seen to be over.
             */
            under_way: number;
            /**
             * Format: double
             * @description The remaining time of the in-flight commands, in seconds (motion model).
             */
            ahead_s: number;
        };
        /** @description The lease holder. */
        LeaseView: {
            /** @description The holder. */
            client: components["schemas"]["ClientId"];
            /** @description The holder's name. */
            name: string;
            /** @description The device of a page; absent for a program. */
            device?: components["schemas"]["Device"] | null;
            /**
             * @description The person the holder counts as for time slots: the name of its token if the token belongs
             *     to a person.
             * @default
             */
            person: string;
            /**
             * @description Whether the holder is a program on the raw port, which cannot answer requests: an
             *     administrator can take control from it.
             * @default false
             */
            is_program: boolean;
            /**
             * Format: double
             * @description When the holder got it, in seconds since the station started.
             */
            since_s: number;
            /** @description The clients that ask for control. */
            asked_by: components["schemas"]["ControlRequest"][];
        };
        /**
         * Format: uint64
         * @description The id of a client while it is connected.
         */
        ClientId: number;
        /** @description The kind of device on which a page is open. */
        Device: "phone" | "computer";
        /** @description A client that asks for control. */
        ControlRequest: {
            /** @description The client. */
            client: components["schemas"]["ClientId"];
            /** @description The client's name. */
            name: string;
            /** @description The device of a page; absent for a program. */
            device?: components["schemas"]["Device"] | null;
        };
        /** @description A lock: only an administrator can take control of the arm. */
        LockView: {
            /** @description Who locked it. */
            by: string;
            /** @description The reason, shown to clients that want to move the arm. */
            message?: string | null;
            /**
             * Format: double
             * @description When it was set, in seconds since the station started.
             */
            at_s: number;
        };
        /** @description The time slots of an arm for observers; `GET /api/v1/slots` returns all of them. */
        SlotsView: {
            /** @description The current slot, if any: only its student and administrators have control meanwhile. */
            now?: components["schemas"]["SlotView"] | null;
            /** @description The next slot, if any. */
            next?: components["schemas"]["SlotView"] | null;
            /**
             * Format: double
             * @description When the arm is free again, in seconds since the station started: the end of the last of the
             *     consecutive slots. Absent if it is free now.
             */
            free_s?: number | null;
        };
        /** @description A time slot, for observers. */
        SlotView: {
            /** @description The student. */
            student: string;
            /** @description The student's group. */
            group?: string | null;
            /**
             * Format: double
             * @description The start, in seconds since the station started.
             */
            starts_s: number;
            /**
             * Format: double
             * @description The end, in seconds since the station started.
             */
            ends_s: number;
        };
        /** @description A stop that holds the arm. */
        StopView: {
            /** @description The name of who stopped it. */
            by: string;
            /** @description The device of a page that stopped it; absent for a program. */
            device?: components["schemas"]["Device"] | null;
            /** @description The client that stopped it, if it was one of this station since it started. */
            client?: components["schemas"]["ClientId"] | null;
            /** @description The reason. */
            reason?: string | null;
            /**
             * Format: double
             * @description When it was set, in seconds since the station started.
             */
            at_s: number;
            /**
             * Format: double
             * @description When the arm is due to be at rest, in seconds since the station started.
             */
            rests_by_s: number;
            /** @description Whether the arm has been seen at rest since. */
            at_rest: boolean;
            /**
             * @description Whether the stop packets have left this computer: if not, switch the arm off by hand.
             * @default true
             */
            delivered: boolean;
            /**
             * @description Whether it is a fleet-wide stop.
             * @default false
             */
            of_fleet: boolean;
        };
        /**
         * @description A fleet-wide stop, or its reset. Every station stores it and sends it to the others.
         *
         *     Of two stops with the same origin, the one with the higher count is newer. The count is set by
         *     the origin alone, so neither other stations' clocks nor the order of messages matter. Stops of
         *     different origins hold independently.
         */
        FleetWideStop: {
            /** @description The id of the station that made it, as in [`Member::id`]. */
            origin: string;
            /**
             * Format: uint64
             * @description The number of the stop at its origin: at least the time it was made, in milliseconds since
             *     1970-01-01T00:00:00Z by the origin's clock, and always higher than the previous one.
             */
            count: number;
            /** @description Who stopped the fleet. */
            by: string;
            /** @description The reason. */
            reason?: string | null;
            /** @description Who reset it for the whole fleet; absent while it holds. */
            reset_by?: string | null;
        };
        /** @description The laser's interlock. */
        LaserView: {
            /**
             * Format: double
             * @description The time for which it may still be switched on, in seconds; 0 when it is disarmed.
             */
            armed_for_s: number;
            /**
             * @description Whether the arm's laser may be on, by its dialect: from the sending of a burning command
             *     until it is over or a laser-off has had time to take effect.
             */
            on: boolean;
        };
        /** @description A job in its current state. */
        JobView: {
            /**
             * Format: uint64
             * @description The job number.
             */
            job: number;
            /** @description The title. */
            title: string;
            /** @description The kind of job. */
            kind: components["schemas"]["JobKind"];
            /**
             * Format: int64
             * @description When it was queued, in milliseconds since 1970-01-01T00:00:00Z.
             */
            created_ms: number;
            /** @description The phase. */
            phase: components["schemas"]["JobPhase"];
            /** @description The reason why it is paused, stopped or failed. */
            reason?: string | null;
            /**
             * @description Whether the job is paused until a person has done something, such as change the pen: it
             *     resumes only after [`Request::ConfirmJob`](crate::Request::ConfirmJob).
             * @default false
             */
            waits_for_person: boolean;
            /**
             * Format: uint
             * @description The number of commands; those of a cycle count once.
             */
            commands: number;
            /**
             * Format: uint
             * @description The number of completed commands in this cycle.
             */
            completed: number;
            /**
             * Format: double
             * @description The planned duration in seconds (motion model), if computed.
             */
            planned_s?: number | null;
            /**
             * Format: double
             * @description The planned remaining time in seconds (motion model), if computed; an estimate if the speed
             *     has been changed.
             */
            left_s?: number | null;
            /**
             * Format: double
             * @description The actual duration in seconds, without pauses; for a job that is done and was not
             *     interrupted by a crash.
             */
            took_s?: number | null;
            /**
             * Format: double
             * @description The speed of its vectors, in percent of the plan.
             */
            speed_percent: number;
            /**
             * Format: double
             * @description The height offset from the plan, in millimetres.
             */
            height_mm: number;
            /** @description The progress in steps and cycles, if it is a program. */
            program?: components["schemas"]["ProgramView"] | null;
            /** @description The question that the job waits for, while the arm is at rest. */
            question?: components["schemas"]["PendingQuestion"] | null;
        };
        /** @description The kind of job. */
        JobKind: "drawing" | "program";
        /** @description The phase of a job. */
        JobPhase: "queued" | "running" | "paused" | "stopped" | "done" | "failed";
        /** @description The progress of a program in steps and cycles. */
        ProgramView: {
            /**
             * Format: uint
             * @description The number of steps.
             */
            steps: number;
            /**
             * Format: uint
             * @description The current step, from 0; the number of steps once all are done.
             */
            step: number;
            /**
             * Format: uint32
             * @description The line of the current step in the text of the program, counted from 1, if it is known.
             */
            line?: number | null;
            /**
             * Format: uint64
             * @description The number of completed cycles.
             */
            cycles_done: number;
            /**
             * Format: uint64
             * @description The total number of cycles; absent if it repeats until it is ended.
             */
            cycles?: number | null;
            /**
             * Format: double
             * @description The planned duration of a cycle in seconds (motion model).
             */
            planned_cycle_s?: number | null;
            /**
             * Format: double
             * @description The mean actual duration of a cycle in seconds, without pauses: over the uninterrupted
             *     cycles since the job was last started.
             */
            mean_cycle_s?: number | null;
        };
        /** @description A question that the job asks after its last command. */
        PendingQuestion: {
            /**
             * Format: uint64
             * @description Its number in the job, from 1.
             * @default 0
             */
            number: number;
            /**
             * Format: double
             * @description How long the job waits for the answer, in seconds; absent: until it is answered.
             */
            timeout_s?: number | null;
            /** @description The answer after the timeout; absent: the job is paused then. */
            otherwise?: components["schemas"]["Answer"] | null;
        } & ({
            /** @constant */
            asks: "choice";
            /** @description The text shown to people. */
            text: string;
            /** @description The possible answers, two or more. */
            answers: string[];
            /** @description Who may answer. */
            by: components["schemas"]["AnsweredBy"];
        } | {
            /** @constant */
            asks: "place";
            /** @description The name of the position. */
            name: string;
        } | {
            /** @constant */
            asks: "next_cycle";
        });
        /** @description Who may answer a question. */
        AnsweredBy: "person" | "seen";
        /** @description The answer to a question. */
        Answer: {
            choice: string;
        } | {
            place: components["schemas"]["GivenPlace"];
        } | "skip" | "next_cycle";
        /** @description A position given to a program: that of the tool's tip in the base frame. */
        GivenPlace: {
            /** @description The name under which the program asks for it; if given, it has to be that name. */
            name?: string | null;
            /**
             * Format: double
             * @description The distance forward of the base axis, in mm.
             */
            x_mm: number;
            /**
             * Format: double
             * @description The distance to the left of the base axis, in mm.
             */
            y_mm: number;
            /**
             * Format: double
             * @description The height above the rear arm's pivot, in mm.
             */
            z_mm: number;
            /**
             * Format: double
             * @description The rotation of the tool, in degrees; default 0.
             * @default 0
             */
            rotation_deg: number;
            /** @description The sense that has located it, if it is no person's own input. */
            sense?: components["schemas"]["Sense"] | null;
        };
        /** @description Where a command comes from, if not from a person's own input. */
        Sense: "camera" | "microphone" | "hand";
        /** @description Facts of the arm; valid until the policy or the dialect changes. */
        ArmFacts: {
            /** @description The lengths of its links and rods. */
            dimensions: components["schemas"]["Dimensions"];
            /** @description The tools that were sold with it. */
            tools: components["schemas"]["ToolFacts"][];
            /** @description The ranges of its joints, by the current policy. */
            joints: components["schemas"]["JointLimits"];
            /** @description The workspace of its tool, by the current policy. */
            workspace: components["schemas"]["Workspace"];
            /**
             * Format: double
             * @description The period of statuses while its queue has space, in seconds; over Bluetooth it is shorter.
             */
            status_period_s: number;
            /**
             * Format: double
             * @description The period of its controller's ticks, in seconds.
             */
            tick_s: number;
            /**
             * Format: double
             * @description The minimum gap between packets that must not get lost, in seconds.
             */
            packet_gap_s: number;
            /** @description The meaning of mouse and gesture packets; absent while the dialect is unknown. */
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
            /** @description The kind of tool. */
            kind: components["schemas"]["Tool"];
            /**
             * Format: double
             * @description The distance from the wrist to the axis of the tool, horizontally, in mm.
             */
            reach_mm: number;
            /**
             * Format: double
             * @description The distance from the wrist down to the tip, by the current policy, in mm.
             */
            length_mm: number;
            /**
             * @description The meaning of gesture packets with this tool (note N18); absent while the dialect is
             *     unknown.
             */
            gesture?: components["schemas"]["GestureFacts"] | null;
        };
        /** @description The units of a gesture packet. */
        GestureFacts: {
            /** @description The X axis. */
            x: components["schemas"]["GestureAxis"];
            /** @description The Y axis. */
            y: components["schemas"]["GestureAxis"];
            /** @description The Z axis. */
            z: components["schemas"]["GestureAxis"];
        };
        /** @description One axis of a gesture packet: its number is (position in mm - `zero_mm`) times `units_per_mm`. */
        GestureAxis: {
            /**
             * Format: double
             * @description The position of the number 0, in mm.
             */
            zero_mm: number;
            /**
             * Format: double
             * @description The number of units per mm.
             */
            units_per_mm: number;
        };
        /** @description The limits of the joints, in degrees; never beyond what the arm itself can do. */
        JointLimits: {
            /**
             * @description Joint 1: -180 to 180 at most, but the cables need 135 or less.
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
             * @description Joint 2 minus joint 3, the opening of the elbow: -105 to 35 at most.
             * @default [
             *       -105,
             *       35
             *     ]
             */
            opening_deg: components["schemas"]["Bounds"];
        };
        /** @description The minimum and maximum allowed, inclusive. In a file: `[min, max]`. */
        Bounds: number[];
        /** @description The limits of the tool's position in the base frame, in mm (z is the height of the wrist). */
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
             * @description Horizontal distance from the axis of the base: 129 to 321 at most.
             * @default [
             *       129,
             *       321
             *     ]
             */
            reach_mm: components["schemas"]["Bounds"];
        };
        /** @description The effect of the arm's dialect on leading it by hand. */
        DialectFacts: {
            /** @description The dialect. */
            name: components["schemas"]["Dialect"];
            /**
             * @description Whether Y of a mouse packet swings the base, to the right if it is positive, and its
             *     rotation is the servo angle (note N9).
             */
            mouse_swings: boolean;
            /**
             * Format: uint
             * @description How many times a gesture packet must be sent until the arm is where the hand is (note N49).
             */
            gesture_samples: number;
        };
        /** @description An event, for all observers. */
        Notice: {
            /**
             * Format: uint64
             * @description Its number, from 1.
             */
            number: number;
            /**
             * Format: double
             * @description The time, in seconds since the station started.
             */
            at_s: number;
            /** @description The event as one line of text. */
            text: string;
        } & ({
            /** @constant */
            type: "link_up";
        } | {
            /** @constant */
            type: "link_lost";
        } | {
            /** @constant */
            type: "no_link";
            /** @description Why. */
            cause: components["schemas"]["LinkCause"];
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
             * @description The command number.
             */
            command: number;
        } | {
            /** @constant */
            type: "heard";
            /** @description The client that holds a button to talk; absent for the listener's own microphone. */
            client?: components["schemas"]["ClientId"] | null;
            /** @description What was understood. */
            heard: components["schemas"]["Heard"];
        } | {
            /** @constant */
            type: "sensed";
            /** @description The client. */
            client: components["schemas"]["ClientId"];
            /** @description The sense. */
            sense: components["schemas"]["Sense"];
            /**
             * Format: uint64
             * @description The command number.
             */
            command: number;
        } | {
            /** @constant */
            type: "command_failed";
            /**
             * Format: uint64
             * @description The command number.
             */
            command: number;
        } | {
            /** @constant */
            type: "pausing";
            /**
             * Format: uint64
             * @description The command number.
             */
            command: number;
            /**
             * Format: double
             * @description The length of the pause, in seconds.
             */
            lasts_s: number;
        } | {
            /** @constant */
            type: "policy_changed";
        } | {
            /** @constant */
            type: "buttons_changed";
        } | {
            /** @constant */
            type: "calibrated";
        } | {
            /** @constant */
            type: "refused";
            /** @description The requester. */
            client: components["schemas"]["ClientId"];
            /** @description The kind of refusal, as in problem documents. */
            kind: string;
        } | {
            /** @constant */
            type: "amended";
            /** @description The client of the program. */
            client: components["schemas"]["ClientId"];
        } | {
            /** @constant */
            type: "lease_taken";
            /** @description The client. */
            client: components["schemas"]["ClientId"];
        } | {
            /** @constant */
            type: "lease_asked";
            /** @description The client. */
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
            /** @description The student. */
            student: string;
        } | {
            /** @constant */
            type: "slot_ending";
            /** @description The student. */
            student: string;
        } | {
            /** @constant */
            type: "slot_ended";
            /** @description The student. */
            student: string;
        } | {
            /** @constant */
            type: "message";
            /** @description The sender. */
            client: components["schemas"]["ClientId"];
        } | {
            /** @constant */
            type: "episode_marked";
            /** @description The mark. */
            mark: components["schemas"]["EpisodeMark"];
            /** @description What the arm does, if the client has said so at the beginning. */
            task?: string | null;
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
             * @description The job number.
             */
            job: number;
            /** @description Its phase. */
            phase: components["schemas"]["JobPhase"];
        } | {
            /** @constant */
            type: "job_asks";
            /**
             * Format: uint64
             * @description The job number.
             */
            job: number;
        } | {
            /** @constant */
            type: "job_answered";
            /**
             * Format: uint64
             * @description The job number.
             */
            job: number;
        } | {
            /** @constant */
            type: "trouble";
        });
        /** @description What was understood of something that was said. */
        Heard: {
            /** @constant */
            what: "order";
            /** @description Its words, as in a voice command. */
            words: string;
        } | {
            /** @constant */
            what: "go";
        } | {
            /** @constant */
            what: "no";
        } | {
            /** @constant */
            what: "stop";
        } | {
            /** @constant */
            what: "nothing";
        };
        /** @description A mark in the recording. */
        EpisodeMark: "begin" | "end" | "discard";
        /**
         * @description The safety policy: what no client's command may do.
         *
         *     Keys missing in a file have the values of [`Policy::DEFAULT_TOML`], which is
         *     [`Policy::default`].
         */
        Policy: {
            /**
             * @description The limits of the joints.
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
             * @description The limits of the tool's position.
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
             * @description The table, which the tool tip may not enter.
             * @default {
             *       "z_mm": -103,
             *       "below_paper_mm": 5
             *     }
             */
            table: components["schemas"]["Table"];
            /**
             * @description The length of each tool.
             * @default {
             *       "suction_cup_mm": 40,
             *       "gripper_mm": 40,
             *       "laser_mm": 38
             *     }
             */
            tool_length: components["schemas"]["ToolLengths"];
            /**
             * @description The thickness of the arm.
             * @default {
             *       "radius_mm": 20
             *     }
             */
            arm: components["schemas"]["ArmBody"];
            /**
             * @description The keep-outs by name, which no part of the arm may touch.
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
             * @description The rules for JUMP moves.
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
             * @description The rules for jogs.
             * @default {
             *       "dead_man_s": 0.15,
             *       "raw_dead_man_s": 1.2,
             *       "reaction_s": 0.25
             *     }
             */
            jog: components["schemas"]["JogRules"];
            /**
             * @description The rules for commands waiting in the arm.
             * @default {
             *       "ahead_s": 0.5,
             *       "line_s": 3600
             *     }
             */
            queue: components["schemas"]["QueueRules"];
            /**
             * @description The rules for spoken orders.
             * @default {
             *       "largest_mm": 50
             *     }
             */
            voice: components["schemas"]["VoiceRules"];
        };
        /** @description The table, which the tool tip may not enter. */
        Table: {
            /**
             * Format: double
             * @description The height of its surface in the base frame, in mm: -300 to 136.
             * @default -103
             */
            z_mm: number;
            /**
             * Format: double
             * @description How far below the paper a tool tip may be if the calibration includes the paper, in mm:
             *     0 to 300.
             * @default 5
             */
            below_paper_mm: number;
        };
        /** @description How far the tip of each tool is below the wrist, in mm: 0 to 200. */
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
        /** @description The thickness of the arm, for keep-outs. */
        ArmBody: {
            /**
             * Format: double
             * @description The radius of the arm around the lines through its links, in mm: 0 to 100.
             * @default 20
             */
            radius_mm: number;
        };
        /** @description A keep-out, which no part of the arm may touch. */
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
        /** @description A vertical cylinder, in mm. */
        Cylinder: {
            /**
             * Format: double
             * @description The x coordinate of its axis (forward).
             */
            x_mm: number;
            /**
             * Format: double
             * @description The y coordinate of its axis (left).
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
        /** @description The highest speeds: configured speed times its percentage. */
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
        /** @description The highest accelerations: configured acceleration times its percentage. */
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
        /** @description The rules for JUMP moves. */
        JumpRules: {
            /**
             * Format: double
             * @description The highest configurable JUMP height, in mm: 0 to 300.
             * @default 150
             */
            height_mm: number;
        };
        /** @description When and where the laser may burn. */
        LaserRules: {
            /**
             * @description Whether the laser may be switched on at all.
             * @default true
             */
            allowed: boolean;
            /**
             * Format: double
             * @description The longest time for which a person may arm it, in s: 1 to 3600.
             * @default 600
             */
            arm_for_s: number;
            /**
             * Format: double
             * @description The minimum of the highest speed of a burning vector, in mm/s: 0 to 1000.
             * @default 1
             */
            least_speed_mm_s: number;
            /**
             * Format: double
             * @description The longest duration of a burning vector, in s: 0.1 to 3600. The arm finishes the
             *     vectors it has received, so the laser may burn this long after a stop.
             * @default 3600
             */
            longest_s: number;
            /**
             * @description Whether it may burn while the arm stands still.
             * @default false
             */
            standing: boolean;
            /**
             * @description Where it may burn: x, y and z as in the workspace.
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
        /** @description The rules for jogs, which continue until they are released. */
        JogRules: {
            /**
             * Format: double
             * @description The time without a message from the client after which a jog is released, in s: 0.05 to
             *     2.
             * @default 0.15
             */
            dead_man_s: number;
            /**
             * Format: double
             * @description The dead-man time for old programs on the raw port, which repeat every 0.5 s, in s: 0.05
             *     to 5.
             * @default 1.2
             */
            raw_dead_man_s: number;
            /**
             * Format: double
             * @description The time from a position to the effect of a release there, in s: 0.05 to 2.
             * @default 0.25
             */
            reaction_s: number;
        };
        /** @description The rules for commands waiting in the arm. */
        QueueRules: {
            /**
             * Format: double
             * @description How early a command may be sent before the arm should begin it, in s: 0 to 60. The arm
             *     may still begin another motion this long after a stop.
             * @default 0.5
             */
            ahead_s: number;
            /**
             * Format: double
             * @description The longest duration of a client's straight line (MOVL), in s: 0.5 to 3600. A longer
             *     line is sent in pieces, between which the arm stands still for a moment; after a stop
             *     the arm finishes the current piece.
             * @default 3600
             */
            line_s: number;
        };
        /** @description The rules for spoken orders. */
        VoiceRules: {
            /**
             * Format: double
             * @description The longest distance of one spoken order, in mm: 1 to 1000. It may have been
             *     misunderstood.
             * @default 50
             */
            largest_mm: number;
        };
        /** @description A new policy. */
        PolicyText: {
            /** @description The TOML text, as shown by `dobot policy`. */
            text: string;
            /**
             * @description Whether to only check the text.
             * @default false
             */
            check: boolean;
        };
        /** @description A change of a keep-out zone in a draft of a policy. */
        EditPolicy: {
            /** @description The TOML text of the draft. */
            text: string;
            /** @description The change. */
            edit: components["schemas"]["KeepOutEdit"];
        };
        /** @description An edit of a keep-out in the text of a policy. */
        KeepOutEdit: {
            /** @constant */
            type: "add";
            /** @description The new keep-out. */
            keep_out: components["schemas"]["KeepOut"];
        } | {
            /** @constant */
            type: "replace";
            /** @description The name, which stays. */
            name: string;
            /** @description The new keep-out. */
            keep_out: components["schemas"]["KeepOut"];
        } | {
            /** @constant */
            type: "remove";
            /** @description The name. */
            name: string;
        };
        /** @description A draft of a policy. */
        PolicyDraft: {
            /** @description Its TOML text. */
            text: string;
        };
        /** @description One event, for the document only. */
        ServerSentEvent: {
            /** @description The type: `state` or `notice`; `packet` or `lost`; `member` or `gone`. */
            event: string;
            /** @description The number of a notice; absent for other events. */
            id?: string | null;
            /**
             * @description As JSON text: a message as in `ToClient`, a packet as in `PacketView`, or a member of the
             *     fleet as in `Member`.
             */
            data: string;
        };
        /** @description A command to be sent. */
        NewCommand: {
            /** @description The command. */
            command: components["schemas"]["Command"];
            /**
             * @description Whether to respond when the command has finished, instead of when it is queued.
             * @default false
             */
            wait: boolean;
        };
        /** @description The answer to an accepted request. */
        Reply: {
            /** @constant */
            type: "done";
        } | {
            /** @constant */
            type: "accepted";
            /**
             * Format: uint64
             * @description The command number.
             */
            command: number;
            /**
             * Format: double
             * @description The time until it is over, including all commands before it, in seconds, if it can be
             *     estimated.
             */
            takes_s?: number | null;
        } | {
            /** @constant */
            type: "way";
            /** @description The path. */
            way: components["schemas"]["PathPreview"];
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
             * @description The time within which the arm is at rest, in seconds; meaningless if not delivered.
             */
            rests_within_s: number;
            /**
             * @description Whether a link accepts the packets. If not, they are sent as soon as there is one;
             *     switch the arm off by hand.
             */
            delivered: boolean;
        } | {
            /** @constant */
            type: "lease";
            /** @description The lease holder, if any. */
            lease?: components["schemas"]["LeaseView"] | null;
        } | {
            /** @constant */
            type: "state";
            /** @description The state. */
            state: components["schemas"]["State"];
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
            /** @description Both calibrations. */
            calibrations: components["schemas"]["Calibrations"];
        } | {
            /** @constant */
            type: "found";
            /** @description The finding and its evidence. */
            finding: components["schemas"]["Finding"];
        };
        /**
         * @description The path a command would take if it were sent now, after all queued commands. The command is
         *     allowed.
         */
        PathPreview: {
            /**
             * Format: double
             * @description The duration of motion and pause, in seconds; absent for a button, which lasts until it is
             *     released.
             */
            takes_s?: number | null;
            /**
             * @description Positions of the tool along the path, including its start and end, at equal time intervals:
             *     x, y and z in millimetres.
             */
            path_mm: number[][];
            /** @description Base, rear arm, forearm and servo angles at the end, in degrees. */
            joints_deg: number[];
        };
        /** @description A time slot, relative to now: no clocks are compared, so a wrong clock does no harm. */
        TimeSlot: {
            /** @description The student: 1 to 60 visible characters. Case and surrounding spaces are ignored. */
            student: string;
            /** @description The student's group: 1 to 40 lowercase English letters, digits and hyphens. */
            group?: string | null;
            /**
             * Format: double
             * @description The start, in seconds from now; 0 if it has begun.
             */
            starts_in_s: number;
            /**
             * Format: double
             * @description The end, in seconds from now: at least a second after the start.
             */
            ends_in_s: number;
        };
        /** @description The calibration of an arm and the previous one. */
        Calibrations: {
            /** @description The current calibration; `None` for an arm that is assumed to match the drawing. */
            calibration?: components["schemas"]["CalibrationFile"] | null;
            /** @description The previous calibration, kept to restore it. */
            before?: components["schemas"]["CalibrationFile"] | null;
        };
        /** @description A stored calibration. */
        CalibrationFile: {
            /** @description The name of the arm, at most 64 characters. */
            name?: string | null;
            /** @description Zero offsets: how much further each joint stands than the arm reports, in degrees. */
            zeros: components["schemas"]["Zeros"];
            /**
             * @description The tool's offset from the drawing of the arm.
             * @default {
             *       "out_mm": 0,
             *       "left_mm": 0
             *     }
             */
            tool: components["schemas"]["ToolOffset"];
            /**
             * @description The position of the base's axis in the sheet's frame, in mm.
             * @default {
             *       "x_mm": 0,
             *       "y_mm": 0
             *     }
             */
            axis: components["schemas"]["Axis"];
            /**
             * @description The position of the paper.
             * @default null
             */
            paper: components["schemas"]["PaperPlane"] | null;
            /**
             * @description The backlash of each joint, in degrees.
             * @default {
             *       "base": 0,
             *       "rear": 0,
             *       "fore": 0
             *     }
             */
            backlash: components["schemas"]["Backlash"];
            /**
             * @description How well the touched points agree.
             * @default null
             */
            touched: components["schemas"]["Touched"] | null;
        };
        /** @description Zero offsets: how much further each joint stands than the arm reports. */
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
        /** @description The tool's offset from the drawing of the arm. */
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
        /** @description The position of the base's axis in the sheet's frame. */
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
         * @description The paper as a surface, given as Z of the wrist where the tool touches it: a plane, plus its
         *     rise above the plane at the touched points.
         */
        PaperPlane: {
            /**
             * Format: double
             * @description The height relative to the base's axis, in mm.
             */
            z_mm: number;
            /**
             * Format: double
             * @description The rise per mm forward.
             */
            slope_x: number;
            /**
             * Format: double
             * @description The rise per mm to the left.
             */
            slope_y: number;
            /**
             * @description The touched points, in mm: forward, left, and the height of the paper above the plane. The
             *     surface is interpolated between them; without points it is flat.
             */
            heights?: number[][];
        };
        /** @description Backlash: how far a motor turns before its joint follows after a reversal. */
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
        /** @description How well the touched points agree. */
        Touched: {
            /**
             * Format: uint
             * @description The number of points used.
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
        /** @description The dialect of an arm, with the evidence. */
        Finding: {
            /** @description The dialect. */
            dialect: components["schemas"]["Dialect"];
            /** @description An answer for each question that was put to the arm. */
            evidence: components["schemas"]["Evidence"][];
        };
        /** @description The behavior of an arm where the dialects differ. */
        Evidence: {
            /** @description The question, with its note. */
            question: string;
            /** @description The observation in the statuses. */
            saw: string;
            /** @description The dialect of an arm that does so. */
            means: components["schemas"]["Dialect"];
        };
        /** @description A command to be checked. */
        CheckCommand: {
            /** @description The command. */
            command: components["schemas"]["Command"];
        };
        /** @description A position of the tool. */
        Place: {
            /**
             * Format: double
             * @description The distance forward of the axis of the base, in mm.
             */
            x_mm: number;
            /**
             * Format: double
             * @description The distance to the left of it, in mm.
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
        /** @description A jog button. */
        HoldJog: {
            /** @description The button. */
            jog: components["schemas"]["Jog"];
        };
        /** @description A jog button. */
        Jog: {
            /** @constant */
            frame: "joint";
            /** @description The axis or switch of the button. */
            axis: components["schemas"]["JointJogAxis"];
            /**
             * Format: float
             * @description The speed in percent of the largest: 1 to 100, and 0 too for a release or a switch.
             */
            speed_percent: number;
        } | {
            /** @constant */
            frame: "linear";
            /** @description The axis or switch of the button. */
            axis: components["schemas"]["LinearJogAxis"];
            /**
             * Format: float
             * @description The speed in percent of the largest: 1 to 100, and 0 too for a release or a switch.
             */
            speed_percent: number;
        };
        /** @description An empty object. */
        Nothing: Record<string, never>;
        /** @description A jog step. */
        NewStep: {
            /** @description The button. */
            button: components["schemas"]["Button"];
            /**
             * Format: float
             * @description The distance, in mm or degrees.
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
             * @description The reason, shown at the stopped arm.
             * @default null
             */
            reason: string | null;
            /**
             * @description The stop of the whole fleet of which this is part; only set by other stations of the fleet.
             * @default null
             */
            fleet: components["schemas"]["FleetWideStop"] | null;
            /**
             * @description The name given by the user of a page, as for its WebSocket.
             * @default null
             */
            name: string | null;
            /**
             * @description The device of a page.
             * @default null
             */
            device: components["schemas"]["Device"] | null;
        };
        /** @description A request for control. */
        LeaseRequest: {
            /**
             * @description The name of the client.
             * @default null
             */
            name: string | null;
        };
        /** @description A granted or pending lease. */
        Granted: {
            /** @description The value of the header `Dobot-Lease` for all requests with this lease. */
            token: string;
            /**
             * Format: uint64
             * @description The time after which the unused token expires, in seconds.
             */
            lasts_s: number;
            /** @description The current lease, if any. */
            lease?: components["schemas"]["LeaseView"] | null;
        };
        /** @description The new lease holder. */
        HandOver: {
            /** @description One of the clients that asked for control. */
            to: components["schemas"]["ClientId"];
        };
        /** @description A lock of the arm. */
        NewLock: {
            /**
             * @description The message for others. Cut to 200 characters.
             * @default null
             */
            message: string | null;
        };
        /** @description The time slots of the arm. */
        NewSlots: {
            /** @description The slots, in any order: up to 200, without overlaps. */
            slots: components["schemas"]["TimeSlot"][];
        };
        /** @description A message to all observers. */
        NewMessage: {
            /** @description The text. Cut to 200 characters. */
            text: string;
        };
        /** @description A student in a lesson. */
        LearnerView: {
            /** @description The student's name. */
            student: string;
            /** @description The name of the lesson's file. */
            lesson: string;
            /**
             * Format: uint32
             * @description The number of completed steps: all of them when the lesson is finished.
             */
            done: number;
            /**
             * Format: uint32
             * @description The number of steps.
             */
            steps: number;
            /**
             * Format: double
             * @description The time that the student has been at this step, in seconds.
             */
            for_s: number;
        };
        /** @description The progress of a student in a lesson. */
        Progress: {
            /** @description The student's name: 1 to 60 visible characters. */
            student: string;
            /**
             * @description The name of the lesson's file, as in `tour`: 1 to 40 lowercase letters a to z, digits and
             *     underscores.
             */
            lesson: string;
            /**
             * Format: uint32
             * @description The number of completed steps: all of them when the lesson is finished.
             */
            done: number;
            /**
             * Format: uint32
             * @description The number of steps, 1 to 1000.
             */
            steps: number;
        };
        /** @description The time for which the laser is armed. */
        ArmLaser: {
            /**
             * Format: double
             * @description The time, in seconds.
             */
            for_s: number;
        };
        /** @description The dialect of the arm. */
        UseDialect: {
            /** @description The dialect. */
            dialect: components["schemas"]["Dialect"];
        };
        /** @description A new calibration. */
        NewCalibration: {
            /** @description The calibration; `null` for nominal dimensions. */
            calibration?: components["schemas"]["CalibrationFile"] | null;
        };
        /** @description A printed sheet and its bar. */
        MeasuredBar: {
            /**
             * Format: uint16
             * @description The number of the sheet, which is printed above its bar.
             */
            sheet: number;
            /**
             * Format: double
             * @description The length of the bar on the print, measured with a ruler, in mm.
             */
            bar_mm: number;
        };
        /** @description Points that the tool has touched. */
        NewTouches: {
            /** @description The reported angles at each point, in the order of touching. */
            touches: components["schemas"]["TouchedPoint"][];
            /**
             * Format: uint16
             * @description The number of the sheet, which is printed above its bar; required.
             * @default null
             */
            sheet: number | null;
            /**
             * Format: double
             * @description The length of the bar on the print, measured with a ruler, in mm; required. A scaled print is
             *     refused.
             * @default null
             */
            bar_mm: number | null;
            /**
             * @description Whether a person has measured the tool and found it about at `tool_mm` of the fit: the answer
             *     to `unmeasured`.
             * @default false
             */
            tool_measured: boolean;
            /**
             * @description Whether the laser is mounted instead of a suction cup.
             * @default false
             */
            laser: boolean;
            /**
             * @description The known backlash of the joints.
             * @default {
             *       "base": 0,
             *       "rear": 0,
             *       "fore": 0
             *     }
             */
            backlash: components["schemas"]["Backlash"];
        };
        /** @description A known point, and the reported angles when the tool touched it. */
        TouchedPoint: {
            /** @description Its position on the sheet: forward and to the left, in mm. */
            place_mm: number[];
            /**
             * Format: double
             * @description Its height above the paper, in mm.
             * @default 0
             */
            height_mm: number;
            /**
             * @description The raw angles of base, rear arm and forearm, in degrees: `raw` of the state of an arm that
             *     is already calibrated.
             */
            raw_deg: number[];
        };
        /** @description The result of fitting a calibration. */
        FitReport: {
            /** @description The calibration. */
            calibration: components["schemas"]["CalibrationFile"];
            /** @description The residual of each touch, in mm. */
            away_mm: number[];
            /** @description The touches that are left out because they contradict all others, at most two, counted from 0. */
            wrong: number[];
            /**
             * Format: uint
             * @deprecated
             * @description The first of `wrong`.
             */
            left_out?: number | null;
            /** @description The position of the tool's tip from the axis of the wrist: outwards and to the left, in mm. */
            tool_mm: number[];
            /**
             * Format: double
             * @description The typical remaining error of a position on the sheet, in mm.
             */
            expected_mm: number;
            /** @description Quantities that these points determine badly. */
            unsure: components["schemas"]["Unsure"][];
            /** @description The most useful further point. */
            advice?: components["schemas"]["Advice"] | null;
            /**
             * @description Whether to use it: `good`; `unchecked` if there are too few points to detect a wrong one;
             *     `unmeasured` if the tool is so far from its nominal position that a person has to measure
             *     whether it is at `tool_mm`; or `doubtful`.
             */
            trust: components["schemas"]["Trust"];
        };
        /** @description A parameter that the touches determine poorly. */
        Unsure: {
            /** @description The parameter. */
            what: string;
            /**
             * Format: double
             * @description Its standard deviation.
             */
            by: number;
            /** @description The unit of the deviation. */
            unit: string;
        };
        /** @description A recommended further point to touch. */
        Advice: {
            /** @description The position on the sheet, in mm. */
            place_mm: number[];
            /**
             * Format: double
             * @description The height above the paper, in mm.
             */
            height_mm: number;
            /**
             * Format: double
             * @description The share of the uncertainty that the point removes, from 0 to 1.
             */
            gain: number;
        };
        /** @description How far a calibration can be trusted. */
        Trust: "good" | "unchecked" | "unmeasured" | "doubtful";
        /** @description Positions of the paper that the tool has touched. */
        PaperTouches: {
            /** @description The positions of the arm: forward, to the left and up, in mm, calibrated, as in its state. */
            places_mm: number[][];
        };
        /** @description The fitted paper. */
        PaperReport: {
            /** @description The part to store in the calibration. */
            paper: components["schemas"]["PaperPlane"];
            /** @description The height of each touch above the plane, in mm. */
            away_mm: number[];
            /**
             * Format: double
             * @description The slope of the plane, in degrees.
             */
            slope_deg: number;
        };
        /** @description The points of the sheet. */
        SheetPoints: {
            /** @description Their positions, forward and to the left of the base's axis, in mm. */
            points_mm: number[][];
            /** @description The four corners of each of its markers 0 to 3, clockwise from the upper left one, in mm. */
            markers_mm: number[][][];
        };
        /** @description A job to queue. */
        NewJob: {
            /** @description The title. */
            title: string;
            /** @description The kind of job. */
            kind: components["schemas"]["JobKind"];
            /** @description The commands, in order. The first motion must be a target (state 3 or 6). */
            commands: components["schemas"]["Command"][];
            /**
             * Format: float
             * @description The height by which the tool is lifted while the job is paused, in millimetres.
             * @default 0
             */
            lift_mm: number;
            /**
             * @description Pauses that wait for a person, in command order.
             * @default []
             */
            pauses: components["schemas"]["JobPause"][];
            /** @description The steps and cycles of a program. */
            program?: components["schemas"]["JobProgram"];
        };
        /** @description A pause where the job waits for a person, for example to change the pen. `start` resumes it. */
        JobPause: {
            /**
             * Format: uint
             * @description The index of the command before which it pauses, from 0. The arm must be at rest there.
             */
            before: number;
            /** @description The message shown to the person. */
            message: string;
        };
        /** @description The steps and cycles of a job. */
        JobProgram: {
            /** @description The index of the first command of each step, in order; if empty, each command is a step. */
            steps?: number[];
            /** @description The line of each step in the text of the program, counted from 1, 0 if unknown; or empty. */
            lines?: number[];
            /** @description The repeated commands. */
            repeat?: components["schemas"]["JobRepeat"] | null;
            /** @description The program, if it asks while it runs. */
            asking?: components["schemas"]["AskingProgram"] | null;
        };
        /** @description A cycle: the commands at the end of a job that repeat. */
        JobRepeat: {
            /**
             * Format: uint
             * @description The index of the first repeated command, from 0; commands before it run once.
             */
            from: number;
            /**
             * Format: uint64
             * @description The total number of cycles; without it, the job repeats until it is ended.
             */
            times?: number | null;
        };
        /**
         * @description A program that asks while it runs. Its job has the commands up to the next question; the answer
         *     adds the commands up to the one after it.
         */
        AskingProgram: {
            /** @description Its TOML text. */
            text: string;
            /** @description The texts of the programs that it calls, by the names used in it. */
            files?: {
                [key: string]: string;
            };
            /** @description The commands of its drawings, by file and options. */
            drawings?: {
                [key: string]: components["schemas"]["Command"][];
            };
            /**
             * Format: uint
             * @description The step that it starts at, counted from 0.
             * @default 0
             */
            from_step: number;
            /** @description The answers given, in order. */
            answers?: components["schemas"]["Answer"][];
            /** @description The question asked after the last command; absent if the program ends there. */
            question?: components["schemas"]["PendingQuestion"] | null;
        };
        /** @description The planned path of a job, once through its commands. */
        JobPath: {
            /**
             * @description Successive positions of the tool: x, y and z in millimetres. Between two of them the tool
             *     moves in a straight line, or visually close to one.
             */
            path_mm: number[][];
            /**
             * @description The command that each position belongs to, from 0; the last position of a command is its
             *     end.
             */
            commands: number[];
            /** @description Whether the segment to each position is drawn or burnt: the laser is on or the pen is down. */
            marks: boolean[];
            /** @description When each position is reached, in seconds since the job began, including the arm's pauses. */
            until_s: number[];
        };
        /** @description A small picture of lines, seen from above by a person behind the arm: -Y to the right, X up. */
        Sketch: {
            /** @description Left, top, width and height of the lines, in mm: the `viewBox` of an SVG. */
            view_mm: number[];
            /**
             * @description The lines as the data of an SVG path, at most 8,192 characters; what is too small to be seen
             *     is left out.
             */
            path: string;
            /**
             * Format: double
             * @description The length of all lines, in mm.
             */
            drawn_mm: number;
        };
        /** @description The place of a queued job in the list. */
        Place2: {
            /**
             * Format: uint64
             * @description The number of the queued job that follows it; by default it becomes the last.
             * @default null
             */
            before: number | null;
        };
        /** @description The drawing speed of a job. */
        Speed: {
            /**
             * Format: double
             * @description The percentage of the planned speed.
             */
            percent: number;
        };
        /** @description The drawing height of a job. */
        Height: {
            /**
             * Format: double
             * @description The offset above the planned height, in millimetres; negative is lower.
             */
            offset_mm: number;
        };
        /** @description An answer to the question of a job. */
        ChosenAnswer: {
            /** @description One of the possible answers. */
            answer: string;
            /**
             * Format: uint64
             * @description The number of the question; an answer to an earlier one is refused.
             */
            question?: number | null;
        };
        /** @description A program, with the files that it uses. */
        ProgramText: {
            /** @description Its TOML text. */
            text: string;
            /**
             * @description The texts of the programs that it calls and of its drawings, by the names used in it.
             * @default {}
             */
            files: {
                [key: string]: string;
            };
        };
        /** @description The steps and problems of a program. */
        ProgramReport: {
            /** @description Its title. */
            title: string;
            /** @description Its steps, in execution order; the steps of a final repeat are listed once. */
            steps: components["schemas"]["StepReport"][];
            /** @description All problems, in the order of the steps or, of a text that cannot be parsed, of its lines. */
            problems: components["schemas"]["ProgramProblem"][];
            /**
             * Format: double
             * @description The duration of the first pass through all steps, in seconds, from the current position of
             *     the arm; null if there are problems.
             */
            once_s?: number | null;
            /**
             * Format: double
             * @description The duration of each further cycle, in seconds; null if nothing is repeated or there are
             *     problems.
             */
            cycle_s?: number | null;
            /**
             * Format: double
             * @description The total duration, in seconds; null if it repeats until a person ends it or there are
             *     problems.
             */
            total_s?: number | null;
            /**
             * @description Whether the program asks while it runs: then steps and durations are those with the first
             *     answer to each question.
             */
            depends_on_answers: boolean;
        };
        /** @description A step of a program. */
        StepReport: {
            /** @description Its description. */
            label: string;
            /** @description The called program that contains it; absent for the program itself. */
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
             * @description Its duration the first time, in seconds.
             */
            takes_s: number;
        };
        /** @description A problem of a program. */
        ProgramProblem: {
            /**
             * Format: uint
             * @description The step, counted from 1 in execution order; absent if the text cannot be parsed.
             */
            step?: number | null;
            /** @description The called program that contains it; absent for the program itself. */
            file?: string | null;
            /**
             * Format: uint
             * @description The line, counted from 1, if it is known.
             */
            line?: number | null;
            /** @description The problem, and what is allowed. */
            message: string;
            /** @description The remedy. */
            remedy?: string | null;
        };
        /** @description Edits of a program's text. */
        EditProgram: {
            /**
             * @description The text; an empty text starts a new program.
             * @default
             */
            text: string;
            /** @description The edits, in order; either all of them are made or none. */
            edits: components["schemas"]["Edit"][];
        };
        /**
         * @description An edit of a program's text; unchanged parts keep their comments and their format. Steps are
         *     those of the program itself, counted from 0.
         */
        Edit: {
            /** @constant */
            type: "insert";
            /**
             * Format: uint
             * @description The number of the new step.
             */
            at: number;
            /** @description The step. */
            step: components["schemas"]["Action"];
        } | {
            /** @constant */
            type: "insert_path";
            /**
             * Format: uint
             * @description The number of the first new step.
             */
            at: number;
            /** @description Its points, in order. */
            places: components["schemas"]["RecordedPlace"][];
            /**
             * Format: double
             * @description The maximum distance of the lines from the points, in mm.
             */
            tolerance_mm: number;
        } | {
            /** @constant */
            type: "replace";
            /**
             * Format: uint
             * @description The number of the step.
             */
            at: number;
            /** @description The new step. */
            step: components["schemas"]["Action"];
        } | {
            /** @constant */
            type: "remove";
            /**
             * Format: uint
             * @description The number of the step.
             */
            at: number;
        } | {
            /** @constant */
            type: "move";
            /**
             * Format: uint
             * @description The number of the step.
             */
            from: number;
            /**
             * Format: uint
             * @description Its new number.
             */
            to: number;
        } | {
            /** @constant */
            type: "set_point";
            /** @description Its name. */
            name: string;
            /** @description Its position. */
            point: components["schemas"]["Point"];
        } | {
            /** @constant */
            type: "rename_point";
            /** @description Its name. */
            name: string;
            /** @description Its new name. */
            to: string;
        } | {
            /** @constant */
            type: "set_grid";
            /** @description Its name. */
            name: string;
            /** @description The first cell, the end of the first row and the end of the first column. */
            corners: components["schemas"]["RecordedPlace"][];
            /** @description The number of its cells. */
            size: components["schemas"]["GridSize"];
        } | {
            /** @constant */
            type: "set_frame";
            /** @description Its name. */
            name: string;
            /** @description The origin, a place on the x axis and one on the side of the y axis. */
            places: components["schemas"]["RecordedPlace"][];
        };
        /** @description The action of a step. */
        Action: {
            /** @description Goes to a place. */
            go?: components["schemas"]["Place3"] | null;
            /** @description The path type: `jump` (default), `movl` in a straight line, or `movj` by the joints. */
            path?: components["schemas"]["MovingMode"] | null;
            /** @description The offset from the place, in mm along the axes of its frame. */
            offset?: components["schemas"]["Offset"] | null;
            /** @description Whether the pump runs from here on. */
            suction?: boolean | null;
            /**
             * Format: double
             * @description The gripper's angle from here on, -90 to 90 degrees.
             */
            gripper?: number | null;
            /**
             * Format: double
             * @description The pause, 0 to 655 seconds.
             */
            pause?: number | null;
            /** @description Switches the laser. */
            laser?: boolean | null;
            /** @description Waits for a person and shows this text of 1 to 200 characters. */
            wait?: string | null;
            /**
             * @description Waits for the other arms of a coordinated program at the barrier of this name, 1 to 40
             *     characters.
             */
            barrier?: string | null;
            /** @description Sets speeds. */
            speed?: components["schemas"]["Speed2"] | null;
            /** @description Selects the mounted tool by name. */
            tool?: string | null;
            /** @description Repeats `steps` this many times, or `"forever"`. */
            repeat?: components["schemas"]["Times"] | null;
            /** @description Repeats `steps` for each cell of a grid, or of several grids in parallel, given by name. */
            each?: components["schemas"]["Names"] | null;
            /** @description The steps of `repeat` and `each`. */
            steps?: components["schemas"]["Step"][] | null;
            /** @description Executes the steps of another program. */
            call?: string | null;
            /** @description Follows an arc from the current position to its end. */
            arc?: components["schemas"]["Arc"] | null;
            /** @description Follows a full circle from the current position. */
            circle?: components["schemas"]["Arc"] | null;
            /** @description Draws a file. */
            drawing?: components["schemas"]["Drawing"] | null;
            /** @description Asks this question of 1 to 200 characters, and executes the steps of the answer in `when`. */
            choose?: string | null;
            /** @description Who answers `choose`: `person` (default), or `seen`: also a camera or another program. */
            by?: components["schemas"]["AnsweredBy"] | null;
            /**
             * Format: uint64
             * @description Instead of `by`: a counter answers `choose`. Every such time gets the first answer, all
             *     others the second one, or nothing.
             */
            every?: number | null;
            /**
             * Format: double
             * @description How long `choose` waits for the answer, in seconds; without it, until it is answered.
             */
            timeout?: number | null;
            /** @description The answer after the timeout; without it, the job is paused. */
            otherwise?: string | null;
            /** @description The answers of `choose`, each with its steps. */
            when?: components["schemas"]["When"][] | null;
            /** @description Sets variables to whole numbers. */
            set?: {
                [key: string]: number;
            } | null;
            /** @description Adds whole numbers to variables. */
            add?: {
                [key: string]: number;
            } | null;
            /** @description Repeats `steps` while this comparison holds, for example `count < 5`. */
            while?: components["schemas"]["Condition"] | null;
            /** @description Picks up the object at a place: from above, down in a straight line, and up again. */
            pick?: components["schemas"]["Place3"] | null;
            /** @description Puts the object down at a place. */
            place?: components["schemas"]["Place3"] | null;
            /**
             * Format: double
             * @description The height above the place from which `pick` and `place` come, 0 to 300 mm; default 20.
             */
            approach?: number | null;
            /**
             * Format: double
             * @description The height above the place to which they go afterwards, 0 to 300 mm; default: `approach`.
             */
            retreat?: number | null;
            /**
             * Format: double
             * @description The time to hold or release the object, 0 to 60 seconds; default 0.3.
             */
            settle?: number | null;
            /** @description What `pick` does if nothing was picked up, as a person or a camera reports. */
            on_missed?: components["schemas"]["Missed"] | null;
        };
        /** @description A place: the name of a point or of a grid (for its current cell), or a point itself. */
        Place3: string | components["schemas"]["Point"] | components["schemas"]["ExternalPlace"];
        /**
         * @description A point: x, y and z in mm, with an optional rotation and frame; or base, rear and fore in
         *     degrees, with an optional servo.
         * @example {
         *       "x": 200,
         *       "y": 0,
         *       "z": 50
         *     }
         * @example {
         *       "base": 0,
         *       "rear": 45,
         *       "fore": 45
         *     }
         * @example {
         *       "from": "cube"
         *     }
         */
        Point: {
            /**
             * Format: double
             * @description The position forward of the base's axis, or along the frame's x axis, in mm.
             */
            x?: number | null;
            /**
             * Format: double
             * @description The position to the left of the base's axis, or along the frame's y axis, in mm.
             */
            y?: number | null;
            /**
             * Format: double
             * @description The height above the rear arm's pivot, or the position along the frame's z axis, in mm.
             */
            z?: number | null;
            /**
             * Format: double
             * @description The rotation of the tool, counter-clockwise from the frame's x axis, in degrees; default 0.
             */
            rotation?: number | null;
            /** @description The name of a frame; default: the base frame. */
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
             * @description The servo's angle in degrees; default 0.
             */
            servo?: number | null;
            /** @description In `go`, `pick` and `place`: the name of a position that is given while the program runs. */
            from?: string | null;
            /**
             * Format: uint16
             * @description If `from` is `seen`: the marker that a camera looks for, 4 to 49.
             */
            marker?: number | null;
            /**
             * Format: double
             * @description How long to wait for that position, in seconds; without it, until it is given.
             */
            timeout?: number | null;
            /** @description What to do after the timeout: `pause` the job (default) or `skip` the step. */
            otherwise?: components["schemas"]["AfterTimeout"] | null;
        };
        /** @description What to do if a position is not given in time. */
        AfterTimeout: "pause" | "skip";
        /** @description A position that is given while the program runs. */
        ExternalPlace: {
            /** @description The name under which it is given, 1 to 40 characters. */
            from: string;
            /**
             * Format: uint16
             * @description If `from` is `seen`: the marker that a camera looks for, 4 to 49. The name is then `marker 7`.
             */
            marker?: number | null;
            /**
             * Format: double
             * @description How long to wait for it, in seconds; without it, until it is given.
             */
            timeout?: number | null;
            /** @description What to do after the timeout. */
            otherwise: components["schemas"]["AfterTimeout"];
        };
        /**
         * @description A displacement along the axes of a frame, in mm.
         * @example {
         *       "x": 0,
         *       "y": 0,
         *       "z": 10
         *     }
         */
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
         * @description Speeds of targets (states 9 and 10; Table 3.9). Omitted values stay unchanged; the initial ones
         *     are those of an arm after power-up.
         * @example {
         *       "percent": 50
         *     }
         */
        Speed2: {
            /**
             * Format: double
             * @description All speeds of targets, in percent of the ones below, above 0 to 100; initially 50.
             */
            percent?: number | null;
            /**
             * Format: double
             * @description All accelerations of targets, in percent, above 0 to 100; initially 50.
             */
            acceleration_percent?: number | null;
            /**
             * Format: double
             * @description The speed of base, rear arm and forearm, in degrees/s; initially 200.
             */
            joint?: number | null;
            /**
             * Format: double
             * @description The acceleration of base, rear arm and forearm, in degrees/s2; initially 200.
             */
            joint_acceleration?: number | null;
            /**
             * Format: double
             * @description The speed of the servo, in degrees/s; initially 200.
             */
            servo?: number | null;
            /**
             * Format: double
             * @description The acceleration of the servo, in degrees/s2; initially 200.
             */
            servo_acceleration?: number | null;
            /**
             * Format: double
             * @description The speed along a line, in mm/s; initially 100.
             */
            line?: number | null;
            /**
             * Format: double
             * @description The acceleration along a line, in mm/s2; initially 200.
             */
            line_acceleration?: number | null;
            /**
             * Format: double
             * @description The lift of a JUMP, in mm, 0 to 300. After power-up it is 10 or 20 mm, depending on the
             *     firmware (note N11); setting one of the speeds above without this sets it to 20.
             */
            jump_height?: number | null;
        };
        /** @description How often, or until a person ends it. */
        Times: number | "forever";
        /** @description One name, or several. */
        Names: string | string[];
        /**
         * @description A step. Exactly one of `go`, `pick`, `place`, `laser`, `wait`, `barrier`, `speed`, `tool`,
         *     `repeat`, `each`, `while`, `choose`, `set`, `add`, `call`, `arc`, `circle` and `drawing` selects
         *     the action; a step with only `suction`, `gripper` and `pause` acts at the current position.
         */
        Step: {
            /** @description Goes to a place. */
            go?: components["schemas"]["Place3"] | null;
            /** @description The path type: `jump` (default), `movl` in a straight line, or `movj` by the joints. */
            path?: components["schemas"]["MovingMode"] | null;
            /** @description The offset from the place, in mm along the axes of its frame. */
            offset?: components["schemas"]["Offset"] | null;
            /** @description Whether the pump runs from here on. */
            suction?: boolean | null;
            /**
             * Format: double
             * @description The gripper's angle from here on, -90 to 90 degrees.
             */
            gripper?: number | null;
            /**
             * Format: double
             * @description The pause, 0 to 655 seconds.
             */
            pause?: number | null;
            /** @description Switches the laser. */
            laser?: boolean | null;
            /** @description Waits for a person and shows this text of 1 to 200 characters. */
            wait?: string | null;
            /**
             * @description Waits for the other arms of a coordinated program at the barrier of this name, 1 to 40
             *     characters.
             */
            barrier?: string | null;
            /** @description Sets speeds. */
            speed?: components["schemas"]["Speed2"] | null;
            /** @description Selects the mounted tool by name. */
            tool?: string | null;
            /** @description Repeats `steps` this many times, or `"forever"`. */
            repeat?: components["schemas"]["Times"] | null;
            /** @description Repeats `steps` for each cell of a grid, or of several grids in parallel, given by name. */
            each?: components["schemas"]["Names"] | null;
            /** @description The steps of `repeat` and `each`. */
            steps?: components["schemas"]["Step"][] | null;
            /** @description Executes the steps of another program. */
            call?: string | null;
            /** @description Follows an arc from the current position to its end. */
            arc?: components["schemas"]["Arc"] | null;
            /** @description Follows a full circle from the current position. */
            circle?: components["schemas"]["Arc"] | null;
            /** @description Draws a file. */
            drawing?: components["schemas"]["Drawing"] | null;
            /** @description Asks this question of 1 to 200 characters, and executes the steps of the answer in `when`. */
            choose?: string | null;
            /** @description Who answers `choose`: `person` (default), or `seen`: also a camera or another program. */
            by?: components["schemas"]["AnsweredBy"] | null;
            /**
             * Format: uint64
             * @description Instead of `by`: a counter answers `choose`. Every such time gets the first answer, all
             *     others the second one, or nothing.
             */
            every?: number | null;
            /**
             * Format: double
             * @description How long `choose` waits for the answer, in seconds; without it, until it is answered.
             */
            timeout?: number | null;
            /** @description The answer after the timeout; without it, the job is paused. */
            otherwise?: string | null;
            /** @description The answers of `choose`, each with its steps. */
            when?: components["schemas"]["When"][] | null;
            /** @description Sets variables to whole numbers. */
            set?: {
                [key: string]: number;
            } | null;
            /** @description Adds whole numbers to variables. */
            add?: {
                [key: string]: number;
            } | null;
            /** @description Repeats `steps` while this comparison holds, for example `count < 5`. */
            while?: components["schemas"]["Condition"] | null;
            /** @description Picks up the object at a place: from above, down in a straight line, and up again. */
            pick?: components["schemas"]["Place3"] | null;
            /** @description Puts the object down at a place. */
            place?: components["schemas"]["Place3"] | null;
            /**
             * Format: double
             * @description The height above the place from which `pick` and `place` come, 0 to 300 mm; default 20.
             */
            approach?: number | null;
            /**
             * Format: double
             * @description The height above the place to which they go afterwards, 0 to 300 mm; default: `approach`.
             */
            retreat?: number | null;
            /**
             * Format: double
             * @description The time to hold or release the object, 0 to 60 seconds; default 0.3.
             */
            settle?: number | null;
            /** @description What `pick` does if nothing was picked up, as a person or a camera reports. */
            on_missed?: components["schemas"]["Missed"] | null;
        };
        /**
         * @description An arc or a circle from the current position, given by two more places on it. The arm follows it
         *     in straight lines (MOVL) and stops after each: a target can be resent after a lost packet, a
         *     vector cannot.
         */
        Arc: {
            /** @description A place on the arc. */
            through: components["schemas"]["Place3"];
            /** @description The end of an arc; the third place of a circle. */
            to: components["schemas"]["Place3"];
            /**
             * Format: double
             * @description The largest distance between the straight lines and the arc, 0.01 to 10 mm; default 0.5.
             * @default 0.5
             */
            tolerance: number;
        };
        /** @description A drawing as a step. The reader of the program prepares it, as `dobot draw` does. */
        Drawing: {
            /** @description The file of the drawing, relative to the program. */
            file: string;
            /**
             * Format: double
             * @description The height of the wrist at which the pen touches the paper, in mm.
             */
            pen_down: number;
            /** @description The options of `dobot draw`, with their names in a request: `place`, `tool`, `way`, `what`. */
            options?: {
                [key: string]: unknown;
            };
        };
        /** @description An answer and its steps. */
        When: {
            /** @description The answer, 1 to 40 characters. */
            answer: string;
            /**
             * @description Its steps; none continue with the next step.
             * @default []
             */
            steps: components["schemas"]["Step"][];
        };
        /** @description A comparison of a variable with a whole number or another variable: `count < 5`; with <, <=, =, !=, >= or >. */
        Condition: string;
        /** @description What to do if nothing was picked up. */
        Missed: {
            /**
             * @description Who reports it: `person` (default) or `seen`, a camera or another program.
             * @default person
             */
            by: components["schemas"]["AnsweredBy"];
            /**
             * Format: uint32
             * @description How often to try again before the steps, 0 to 100; default 0.
             * @default 0
             */
            retries: number;
            /**
             * @description The steps if it is still not picked up.
             * @default []
             */
            steps: components["schemas"]["Step"][];
        };
        /** @description A place of a path: the position and the state of the tool. */
        RecordedPlace: {
            /** @description x, y and z, in millimetres in the base frame. */
            point_mm: number[];
            /**
             * Format: double
             * @description The rotation of the tool in the base frame, in degrees.
             */
            rotation_deg: number;
            /** @description Whether the pump runs. */
            suction: boolean;
            /**
             * Format: double
             * @description The gripper's angle, in degrees.
             */
            gripper_deg: number;
        };
        /** @description The number of cells of a grid. As a text: `3x4`, or with layers `3x4x2`. */
        GridSize: {
            /**
             * Format: uint32
             * @description The cells in a row, 1 to 1000.
             */
            columns: number;
            /**
             * Format: uint32
             * @description The rows in a layer, 1 to 1000.
             */
            rows: number;
            /**
             * Format: uint32
             * @description The layers, 1 to 1000.
             * @default 1
             */
            layers: number;
            /**
             * Format: double
             * @description The distance from a layer to the next one, in mm upwards; negative goes down, from the top of
             *     a stack. With one layer 0.
             * @default 0
             */
            layer_mm: number;
        };
        /** @description The text of a program. */
        EditedProgram: {
            /** @description The text. */
            text: string;
            /**
             * Format: uint
             * @description The number of steps.
             */
            steps: number;
        };
        /** @description The content of a program, to be put into a text. */
        MergeProgram: {
            /** @description The text, with its comments and its format. */
            text: string;
            /** @description The new content, as TOML; it may have problems, and keys that no program has. */
            content: string;
        };
        /** @description The text with the new content. */
        MergedProgram: {
            /** @description The text. */
            text: string;
        };
        /** @description A program to be converted to another format. */
        ConvertProgram: {
            /**
             * @description Its text; a file of the vendor's software has bytes instead.
             * @default null
             */
            text: string | null;
            /**
             * @description The bytes of a file, in Base64.
             * @default null
             */
            data: string | null;
            /** @description The format of the bytes; a text is a program. */
            from?: components["schemas"]["ProgramForm"];
            /**
             * @description The texts of the programs that it calls and of its drawings, by the names used in it.
             * @default {}
             */
            files: {
                [key: string]: string;
            };
            /** @description The target format. */
            to: components["schemas"]["ProgramForm"];
        };
        /** @description The file format of a program. */
        ProgramForm: "toml" | "xml" | "play" | "playback";
        /** @description A converted program. */
        ConvertedProgram: {
            /** @description The text. */
            text: string;
            /** @description Unexpected contents, and what the target format cannot represent. */
            warnings: string[];
        };
        /** @description A program to be queued as a job. */
        NewProgram: {
            /** @description The program. */
            program: components["schemas"]["ProgramText"];
            /**
             * Format: uint
             * @description The first step to execute, counted from 1 in execution order; by default 1.
             * @default null
             */
            from_step: number | null;
            /**
             * Format: uint
             * @description Instead of `from_step`, a line of the text, counted from 1: it starts at the first step on
             *     this line or after it, following the answers that lead there.
             * @default null
             */
            from_line: number | null;
            /** @description The number of repetitions; by default that of the program. */
            times?: components["schemas"]["Repeat"] | null;
            /**
             * Format: uint64
             * @description The number of the stored file that contains the program, for which the job is noted.
             * @default null
             */
            stored: number | null;
        };
        /** @description The number of repetitions of a program. */
        Repeat: {
            /** Format: uint64 */
            count: number;
        } | "forever";
        /** @description A button that a person has added to the page. */
        CustomButton: {
            /** @description Its label, different from that of all others: 1 to 30 printable characters. */
            name: string;
            /** @description Its colour. */
            color: components["schemas"]["ButtonColor"];
            /** @description The effect of a press. */
            action: components["schemas"]["ButtonAction"];
        };
        /**
         * @description The colour of a button. Red is the colour of STOP.
         * @enum {string}
         */
        ButtonColor: "grey" | "blue" | "green" | "yellow" | "purple";
        /** @description The effect of a button. */
        ButtonAction: {
            /** @constant */
            type: "position";
            /**
             * Format: float
             * @description X, in millimetres.
             */
            x_mm: number;
            /**
             * Format: float
             * @description Y, in millimetres.
             */
            y_mm: number;
            /**
             * Format: float
             * @description Z, in millimetres.
             */
            z_mm: number;
            /**
             * Format: float
             * @description The rotation of the tool, in degrees.
             */
            rotation_deg: number;
            /** @description The path. */
            mode: components["schemas"]["MovingMode"];
        } | {
            /** @constant */
            type: "command";
            /** @description The command. */
            command: components["schemas"]["Command"];
        } | {
            /** @constant */
            type: "program";
            /** @description Its TOML text. */
            text: string;
        };
        /** @description Whether a listener runs. */
        Listener: {
            /** @description Whether it has asked for audio in the last seconds. */
            listens: boolean;
        };
        /** @description A piece of what a client says. */
        TalkPiece: {
            /** @description The client. */
            client: components["schemas"]["ClientId"];
            /** @description Samples at 16 kHz, 16 bits, little-endian, one channel, as Base64; empty at the end of what is said. */
            pcm: string;
        };
        /** @description A mark in the recording. */
        NewMark: {
            /** @description The mark. */
            mark: components["schemas"]["EpisodeMark"];
            /**
             * @description What the arm does; only with `begin`. Cut to 200 characters.
             * @default null
             */
            task: string | null;
        };
        /** @description A recording. */
        RecordingView: {
            /** @description The name of its file. */
            name: string;
            /**
             * Format: int64
             * @description Its begin, in milliseconds since 1970-01-01T00:00:00Z.
             */
            begin_ms: number;
            /**
             * Format: uint64
             * @description Its size, in bytes.
             */
            bytes: number;
            /** @description Whether it is still being written. */
            being_written: boolean;
        };
        /** @description The positions of the arm over a part of a recording. */
        RecordedStates: {
            /**
             * Format: int64
             * @description The origin of its times, in milliseconds since 1970-01-01T00:00:00Z; absent if nothing could
             *     be read.
             */
            begin_ms?: number | null;
            /**
             * Format: double
             * @description The minimum spacing of the samples, in seconds; 0 if all changes are included.
             */
            spacing_s: number;
            /** @description The statuses, the oldest first. The arm did not move between two equal ones. */
            samples: components["schemas"]["SampleView"][];
        };
        /** @description The status at one moment. */
        SampleView: {
            /**
             * Format: double
             * @description The time, in seconds since the origin of the recording.
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
        /** @description A drawing to be planned: a file, the text in the options or both, or a test card. */
        NewDrawing: {
            /**
             * @description The name of the file; its extension determines the format.
             * @default null
             */
            name: string | null;
            /**
             * @description The contents of the file, in Base64 (RFC 4648).
             * @default null
             */
            file: string | null;
            /**
             * Format: uint64
             * @description The number of a stored file, instead of a name and its contents; the options of its job are
             *     stored with it.
             */
            stored?: number | null;
            /**
             * @description The options, as those of `dobot draw`.
             * @default {
             *       "what": {
             *         "text": null,
             *         "font": null,
             *         "height": null,
             *         "align": null,
             *         "wrap": null,
             *         "justify": false,
             *         "card": null,
             *         "card_passes": null,
             *         "card_size": null,
             *         "card_gap": null,
             *         "card_label": null,
             *         "layers": null,
             *         "layer": [],
             *         "only": [],
             *         "no_crop": false,
             *         "gcode": null,
             *         "strict": false,
             *         "hide": false,
             *         "white_edges": false,
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
             *         "border": false,
             *         "crop_marks": false,
             *         "sign": null,
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
             *         "tries": 30000,
             *         "seed": 1,
             *         "from": null
             *       }
             *     }
             */
            options: components["schemas"]["Options"];
        };
        /**
         * @description The options of a drawing. [`DrawingRequest::new`] converts them to
         *     [`Settings`](crate::Settings); `dobot draw` reads them from its arguments, other clients from
         *     JSON:
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
             * @description What to draw
             * @default {
             *       "text": null,
             *       "font": null,
             *       "height": null,
             *       "align": null,
             *       "wrap": null,
             *       "justify": false,
             *       "card": null,
             *       "card_passes": null,
             *       "card_size": null,
             *       "card_gap": null,
             *       "card_label": null,
             *       "layers": null,
             *       "layer": [],
             *       "only": [],
             *       "no_crop": false,
             *       "gcode": null,
             *       "strict": false,
             *       "hide": false,
             *       "white_edges": false,
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
             * @description Where to draw it
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
             *       "border": false,
             *       "crop_marks": false,
             *       "sign": null,
             *       "clip": false,
             *       "pen_down": null,
             *       "paper": null,
             *       "offset": 0
             *     }
             */
            place: components["schemas"]["PlaceOptions"];
            /**
             * @description The tool to draw with
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
             * @description How to draw it
             * @default {
             *       "tolerance": 0.05,
             *       "join": null,
             *       "drop_doubles": false,
             *       "keep_order": false,
             *       "tries": 30000,
             *       "seed": 1,
             *       "from": null
             *     }
             */
            way: components["schemas"]["PathOptions"];
        };
        /** @description What to draw */
        ContentOptions: {
            /**
             * @description Text to draw, alone or below the files; \n starts a new line
             * @default null
             */
            text: string | null;
            /**
             * @description Font of `what.text`: a single-stroke font (sans, bold, script, serif, italic, gothic, hand),
             *     an SVG font (its file; in JSON its content), or any installed font (default: sans)
             * @default null
             */
            font: string | null;
            /**
             * Format: double
             * @description Capital height of `what.text` on the paper, in mm (default: 10 mm, scaled with the drawing)
             * @default null
             */
            height: number | null;
            /**
             * @description Alignment of `what.text`: left, center or right (default: left)
             * @default null
             */
            align: components["schemas"]["Align"] | null;
            /**
             * Format: double
             * @description Width at which lines of `what.text` are wrapped, in mm (default: at the margins of
             *     `place.paper_size`)
             * @default null
             */
            wrap: number | null;
            /**
             * @description Widen spaces so that wrapped lines have the full width
             * @default false
             */
            justify: boolean;
            /**
             * @description Burn a laser test card with a column for each of these speeds, in mm/s
             * @default null
             */
            card: number[] | null;
            /**
             * Format: uint32
             * @description Number of rows of the test card: row n is burned n times (default: 3)
             * @default null
             */
            card_passes: number | null;
            /**
             * Format: double
             * @description Size of the fields of the test card, in mm (default: 6)
             * @default null
             */
            card_size: number | null;
            /**
             * Format: double
             * @description Gap between the fields of the test card, in mm (default: 2)
             * @default null
             */
            card_gap: number | null;
            /**
             * @description Label below the test card (default: the name of the material and the date)
             * @default null
             */
            card_label: string | null;
            /**
             * @description Split an SVG file into layers by `color`, outermost `group` or line `width`, other files by
             *     their layers; each is drawn separately, and the arm waits for its pen
             * @default null
             */
            layers: components["schemas"]["LayersBy"] | null;
            /**
             * @description Draw a layer with its own pen or material
             * @default []
             */
            layer: components["schemas"]["LayerTool"][];
            /**
             * @description Draw only these layers, by name; separate several by commas, or repeat `what.only`
             * @default []
             */
            only: string[];
            /**
             * @description Also draw content beyond the page of an SVG file, instead of cropping it
             * @default false
             */
            no_crop: boolean;
            /**
             * @description Read G-code as a program for a laser, a pen or a mill (default: as the file suggests)
             * @default null
             */
            gcode: components["schemas"]["GcodeTool"] | null;
            /**
             * @description Refuse a file with a mistake, instead of drawing it without what the mistake spoils
             * @default false
             */
            strict: boolean;
            /**
             * @description Remove what is covered by filled shapes painted over it, including white ones
             * @default false
             */
            hide: boolean;
            /**
             * @description Draw the edges of white shapes of an SVG file that lie on darker ones, as `what.hide` does
             * @default false
             */
            white_edges: boolean;
            /**
             * @description Hatch filled areas with this line spacing, in mm (default: as suits the pen or material)
             * @default null
             */
            hatch: components["schemas"]["Spacing"] | null;
            /**
             * Format: double
             * @description Hatch angle, in degrees counterclockwise from left to right
             * @default 45
             */
            hatch_angle: number;
            /**
             * @description Hatch style: lines, concentric (the outline repeated inwards) or spiral (concentric in a
             *     single line)
             * @default lines
             */
            hatch_style: components["schemas"]["HatchStyle"];
            /**
             * Format: double
             * @description Distance of the hatching from the edge, in mm; half the width of the pen keeps the ink
             *     inside
             * @default 0
             */
            hatch_inset: number;
            /**
             * @description Cross-hatch
             * @default false
             */
            cross: boolean;
            /**
             * @description Rendering of a picture: hatch, lines, spiral, flow, stipple, tsp (a single line through
             *     dots) or outline
             * @default null
             */
            shade: components["schemas"]["ShadingStyle"] | null;
            /**
             * Format: double
             * @description Spacing of the lines or dots of a picture, or of the lines of the test card, in mm on the
             *     paper
             * @default null
             */
            spacing: number | null;
            /**
             * Format: double
             * @description Picture brightness, -100 to 100 percent
             * @default 0
             */
            brightness: number;
            /**
             * Format: double
             * @description Picture contrast, -100 to 100 percent
             * @default 0
             */
            contrast: number;
            /**
             * Format: double
             * @description Picture gamma: above 1 makes the midtones lighter, below 1 darker
             * @default 1
             */
            gamma: number;
            /**
             * Format: double
             * @description Convert a picture to black and white at this darkness, between 0 (white) and 1
             * @default null
             */
            threshold: number | null;
            /**
             * Format: uint8
             * @description Number of tones besides white in the styles outline and hatch, 1 to 8 (default: 4)
             * @default null
             */
            levels: number | null;
            /**
             * @description Draw the light parts of a picture instead of the dark ones
             * @default false
             */
            invert: boolean;
        };
        /** @description The alignment of lines. */
        Align: "left" | "center" | "right";
        /** @description The layers of an SVG file. */
        LayersBy: "color" | "group" | "width" | "nothing";
        /** @description A layer with its own pen or material: `NAME=PEN`. */
        LayerTool: {
            /** @description The name of the layer. */
            name: string;
            /** @description The name of its pen or material. */
            pen: string;
        };
        /** @description The tool that a G-code file controls. */
        GcodeTool: "laser" | "pen" | "mill";
        /** @description The line spacing of a hatching: `auto` or millimetres. */
        Spacing: number | components["schemas"]["Auto"];
        /** @description The word `auto`. */
        Auto: "auto";
        /** @description The style of a hatching. */
        HatchStyle: "lines" | "concentric" | "spiral";
        /** @description The style of a shaded picture. */
        ShadingStyle: "outline" | "lines" | "spiral" | "flow" | "stipple" | "tsp" | "hatch";
        /** @description Where to draw it */
        PlaceOptions: {
            /**
             * @description Sheet to draw on: a3 to a7, b5, b6, letter, legal, tabloid, postcard, `210x148` in mm or
             *     `5x7in`; the page of the file keeps its upper left corner
             * @default null
             */
            paper_size: components["schemas"]["PaperSize"] | null;
            /**
             * @description Place the sheet with its longer side from left to right
             * @default false
             */
            landscape: boolean;
            /**
             * @description Position of the sheet's lower left corner, in mm: the corner closest to you on the left when
             *     you stand behind the arm (default: the sheet is centred in front of the arm)
             * @default null
             */
            corner: number[] | null;
            /**
             * @description Fit to the sheet or the drawing area
             * @default false
             */
            fit: boolean;
            /**
             * Format: double
             * @description Scale factor relative to the true size
             * @default null
             */
            scale: number | null;
            /**
             * @description Centre of the drawing or the sheet, in mm (default: the centre of the drawing area)
             * @default null
             */
            at: number[] | null;
            /**
             * @description Mirror left and right
             * @default false
             */
            mirror: boolean;
            /**
             * @description Draw copies in a grid of columns and rows, as in 3x2; several files fill the cells in turn,
             *     with `place.fit` each as large as its cell allows
             * @default null
             */
            grid: components["schemas"]["Grid"] | null;
            /**
             * Format: double
             * @description Gap between the copies or files of `place.grid`, between a file and `what.text` below it, and
             *     inside `place.border`, in mm of the file
             * @default 5
             */
            gap: number;
            /**
             * Format: double
             * @description Rotation counterclockwise, in degrees
             * @default 0
             */
            rotate: number;
            /**
             * Format: double
             * @description Margin of the sheet or the drawing area, in mm
             * @default 0
             */
            margin: number;
            /**
             * @description Draw a border at the margin of the sheet, or around the drawing
             * @default false
             */
            border: boolean;
            /**
             * @description Draw crop marks outside the corners of the border
             * @default false
             */
            crop_marks: boolean;
            /**
             * @description Sign in the lower right corner with this text, in script letters 4 mm high
             * @default null
             */
            sign: string | null;
            /**
             * @description Cut off what lies beyond the sheet or out of reach, instead of refusing the drawing
             * @default false
             */
            clip: boolean;
            /**
             * Format: double
             * @description Z at which the pen draws, in mm (default: the current height of the arm; -40 for a virtual
             *     arm)
             * @default null
             */
            pen_down: number | null;
            /**
             * @description Three touched points of the paper, for paper that is not level; with `place.paper_size`
             *     first the lower left corner of the sheet, then another point on its lower edge
             * @default null
             */
            paper: number[] | null;
            /**
             * Format: double
             * @description Height offset of the pen, in mm; a negative offset presses harder
             * @default 0
             */
            offset: number;
        };
        /**
         * @description The size of a sheet: a name such as `a5`, or width and height in mm or inches, as in `210x148` or
         *     `5x7in`.
         */
        PaperSize: string;
        /** @description A grid of columns and rows for copies or files, as in `3x2`: three columns and two rows. */
        Grid: string;
        /** @description The tool to draw with */
        ToolOptions: {
            /**
             * @description Pen to draw with
             * @default fineliner
             */
            pen: string;
            /**
             * @description Material to burn with the laser
             * @default null
             */
            laser: string | null;
            /**
             * Format: double
             * @description Lift of the pen while travelling, in mm
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
             * @description Travel speed between strokes, in mm/s
             * @default null
             */
            travel_speed: number | null;
            /**
             * Format: uint32
             * @description Number of passes; a pen repeats each line before it is lifted
             * @default null
             */
            passes: number | null;
            /**
             * @description What the laser repeats before continuing: each shape, or the whole layer
             * @default layer
             */
            passes_by: components["schemas"]["PassesBy"];
            /**
             * Format: double
             * @description Width of the laser's cut, in mm: closed shapes are cut larger by half of it, and holes in
             *     them smaller; a negative width does the opposite
             * @default 0
             */
            kerf: number;
            /**
             * Format: double
             * @description Length of the lead-in to each cut, in mm
             * @default 0
             */
            lead_in: number;
            /**
             * Format: double
             * @description Distance to cut past the start point, in mm
             * @default 0
             */
            overcut: number;
            /**
             * Format: uint32
             * @description Number of tabs that hold each shape in place
             * @default 0
             */
            tabs: number;
            /**
             * Format: double
             * @description Width of a tab, in mm
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
        /** @description What a laser repeats before it continues. */
        PassesBy: "shape" | "layer";
        /** @description How to draw it */
        PathOptions: {
            /**
             * Format: double
             * @description Maximum deviation of the drawn path, in mm
             * @default 0.05
             */
            tolerance: number;
            /**
             * Format: double
             * @description Join strokes whose ends are this close, in mm (default: the tolerance)
             * @default null
             */
            join: number | null;
            /**
             * @description Remove duplicate lines; of shapes to cut out, only complete duplicates
             * @default false
             */
            drop_doubles: boolean;
            /**
             * @description Keep the stroke order of the file
             * @default false
             */
            keep_order: boolean;
            /**
             * Format: uint32
             * @description Number of attempts to shorten the pen-up travel for 10,000 strokes and more; fewer for fewer
             * @default 30000
             */
            tries: number;
            /**
             * Format: uint64
             * @description Random seed for the stroke order; the same seed gives the same order
             * @default 1
             */
            seed: number;
            /**
             * @description Resume at a layer, a stroke or a share of the ink, as in layer:red, stroke:120 or 40%
             * @default null
             */
            from: components["schemas"]["ResumePoint"] | null;
        };
        /**
         * @description The resume point of an interrupted drawing: `layer:NAME`, `stroke:NUMBER` or a share such as
         *     `40%`.
         */
        ResumePoint: string;
        /** @description A drawing with the state of its plan. */
        DrawingView: {
            /**
             * Format: uint64
             * @description Its number.
             */
            drawing: number;
            /** @description Its title. */
            title: string;
            /** @description The phase of its planning. */
            phase: components["schemas"]["DrawingPhase"];
            /** @description The reason why it cannot be planned. */
            problem?: components["schemas"]["Problem"] | null;
            /** @description The plan. */
            plan?: components["schemas"]["DrawingPlan"] | null;
        };
        /** @description The phase of a drawing's planning. */
        DrawingPhase: "waiting" | "planning" | "planned" | "failed";
        /** @description The plan of a drawing. */
        DrawingPlan: {
            /**
             * Format: double
             * @description The scale relative to the size in the file.
             */
            scale: number;
            /** @description Whether a laser is used. */
            burns: boolean;
            /** @description Differences between the result and the file. */
            warnings: string[];
            /** @description The pauses for a person, with their messages. */
            pauses: string[];
            /** @description The reason why the arm may not draw it from its current position. */
            refused?: components["schemas"]["Problem"] | null;
            /** @description The drawing over time, pass by pass and vector by vector. */
            timeline: components["schemas"]["Timeline"];
        };
        /**
         * @description The timeline of a drawing, for a page on which a person can move to any moment.
         *
         *     All numbers are millimetres in the base frame (X forward, Y to the left, Z up) and seconds from
         *     the start. Tables are stored as columns of equal length, which is far smaller than named rows.
         *
         *     **Position at time `t`.** The path is straight between rows, at constant speed. Find the last
         *     row `i` with `path.t_s[i] <= t` (binary search; the column never decreases) and interpolate with
         *     the share `(t - t_s[i]) / (t_s[i + 1] - t_s[i])` to row `i + 1`; the drawing ends at the last
         *     row. The result is within 0.05 mm of the tool. The paper shows all lines up to row `i`, and the
         *     piece from row `i` to the tool if row `i + 1` has ink 1. The pen or the laser leaves ink at that
         *     time if row `i + 1` has ink 1.
         *
         *     **Move at time `t`.** Find the last row of `moves` with `from_s <= t` in the same way. A move
         *     ends when the next one begins, the last one at `duration_s`.
         *
         *     **Drawing.** Iterate over the path: a row with ink 2 begins a line (a dot if no other row
         *     follows), a row with ink 1 continues it, a row with ink 0 ends it. The colour of a line is that
         *     of its pass (of the move at its time), or derived from `error_mm`.
         */
        Timeline: {
            /**
             * Format: uint32
             * @description The version of this format: 1. A page refuses unknown versions.
             */
            version: number;
            /**
             * Format: double
             * @description The duration of the drawing.
             */
            duration_s: number;
            /**
             * Format: double
             * @description The sampling interval; `path` contains only the necessary samples.
             */
            tick_s: number;
            /** @description The bounds of the path: minimum and maximum of X, Y and Z. */
            bounds_mm: number[][];
            /** @description The passes in order. */
            passes: components["schemas"]["PassFigures"][];
            /** @description The moves of the tool, in order. */
            moves: components["schemas"]["Moves"];
            /** @description The path of the tool and its ink. */
            path: components["schemas"]["Path"];
        };
        /** @description The statistics of a pass. */
        PassFigures: {
            /** @description The name. */
            name: string;
            /** @description Red, green and blue, if the file specifies a colour. */
            color?: number[] | null;
            /** @description The tool: `pen` or `laser`. */
            tool: components["schemas"]["Tool"];
            /**
             * Format: uint
             * @description The number of strokes, counting repetitions.
             */
            strokes: number;
            /**
             * Format: uint
             * @description The number of vectors, which is the number of packets.
             */
            vectors: number;
            /**
             * Format: double
             * @description The length of its lines on the paper, in mm.
             */
            ink_mm: number;
            /**
             * Format: double
             * @description The length of the tool's path without ink, including the way to its first stroke, in mm.
             */
            travel_mm: number;
            /**
             * Format: double
             * @description The time from the end of the pass before to its own end, in seconds.
             */
            time_s: number;
            /**
             * Format: double
             * @description The maximum distance of its ink from the wanted path, in mm.
             */
            error_mm: number;
        };
        /** @description The moves of the tool, one row each. */
        Moves: {
            /** @description The names of the numbers in `kind`. */
            kinds: string[];
            /** @description The kind of move, as an index in `kinds`. */
            kind: number[];
            /** @description The pass, as an index in `passes`. */
            pass: number[];
            /** @description The stroke, from 0, counted through all passes. */
            stroke: number[];
            /** @description The start time. */
            from_s: number[];
        };
        /** @description The path of the tool, one row per relevant moment. */
        Path: {
            /** @description The time. */
            t_s: number[];
            /** @description Forward. */
            x_mm: number[];
            /** @description To the left. */
            y_mm: number[];
            /** @description Up. */
            z_mm: number[];
            /** @description 0: no ink; 1: a line from the row before; 2: a dot, which may begin a line. */
            ink: number[];
            /** @description The distance of the ink from the wanted path; 0 without ink. */
            error_mm: number[];
        };
        /** @description The part of a drawing to be queued as a job. */
        DrawingJob: {
            /** @description The part. */
            part?: components["schemas"]["DrawingPart"];
        };
        /** @description The part of a drawing that a job draws. */
        DrawingPart: "whole" | "frame";
        /** @description A pen, or a material for the laser. */
        MaterialView: {
            /** @description Its name. */
            name: string;
            /** @description Its tool: `pen` or `laser`. */
            tool: components["schemas"]["Tool"];
        };
        /** @description A file format. */
        Format: {
            /** @description The name, as in `HP-GL`. */
            name: string;
            /** @description The file name extensions in lower case, without dots; the usual one first. */
            extensions: string[];
            /** @description The MIME type. */
            mime_type: string;
            /** @description The content of its files. */
            contents: components["schemas"]["Contents"];
        };
        /** @description The content of the files of a format. */
        Contents: "page" | "shapes" | "lines" | "picture";
        /** @description The files and their space. */
        FilesView: {
            /**
             * Format: uint64
             * @description The size of all contents together, in bytes.
             */
            used_bytes: number;
            /**
             * Format: uint64
             * @description Its maximum.
             */
            most_bytes: number;
            /**
             * Format: uint
             * @description The maximum number of files.
             */
            most_files: number;
            /** @description Why files are missing in the list, a line each. */
            damaged: string[];
            /** @description The files, the oldest first. */
            files: components["schemas"]["FileView"][];
        };
        /** @description A stored file. */
        FileView: {
            /**
             * Format: uint64
             * @description Its number.
             */
            file: number;
            /** @description Its name. */
            name: string;
            /** @description What it is. */
            kind: components["schemas"]["FileKind"];
            /**
             * Format: uint64
             * @description Its revision, from 1: each change by a person is another one.
             */
            revision: number;
            /**
             * Format: uint64
             * @description The size of its content, in bytes.
             */
            bytes: number;
            /** @description The SHA-256 digest of its content, in hexadecimal. */
            sha256: string;
            /**
             * Format: int64
             * @description When it was added, in milliseconds since 1970-01-01T00:00:00Z.
             */
            added_ms: number;
            /**
             * Format: int64
             * @description When a person changed it last.
             */
            changed_ms: number;
            /** @description The last placement, pen and other options of its drawing. */
            options?: components["schemas"]["Options"] | null;
            /** @description The last job made from it. */
            last_job?: components["schemas"]["FileJob"] | null;
            /** @description Whether it has a picture. */
            has_sketch: boolean;
            /** @description Why it cannot be drawn, if that is known. */
            problem?: string | null;
        };
        /** @description The kind of a file, by the end of its name. */
        FileKind: "drawing" | "photo" | "program";
        /** @description The last job made from a file. */
        FileJob: {
            /**
             * Format: uint64
             * @description Its number.
             */
            job: number;
            /**
             * Format: int64
             * @description When it was queued, in milliseconds since 1970-01-01T00:00:00Z.
             */
            queued_ms: number;
            /** @description Its last known phase. */
            phase: components["schemas"]["JobPhase"];
            /**
             * Format: double
             * @description Its actual duration, in seconds, once it is done.
             */
            took_s?: number | null;
        };
        /** @description A file to be stored. */
        NewFile: {
            /** @description Its name, which ends like that of a drawing, a picture or a program. */
            name: string;
            /** @description Its content, in Base64 (RFC 4648). */
            content: string;
            /**
             * @description The options of its drawing.
             * @default null
             */
            options: components["schemas"]["Options"] | null;
            /** @description What to do if a file of this name has other content. */
            existing?: components["schemas"]["Existing"];
        };
        /** @description What to do if a file of the same name has other content. */
        Existing: "refuse" | "replace" | "keep_both";
        /** @description A change of a file; absent parts stay. */
        ChangeFile: {
            /**
             * Format: uint64
             * @description The revision that is changed: a change of another one is refused.
             */
            revision: number;
            /**
             * @description The new name.
             * @default null
             */
            name: string | null;
            /**
             * @description The new content, in Base64 (RFC 4648).
             * @default null
             */
            content: string | null;
            /**
             * @description The options of its drawing.
             * @default null
             */
            options: components["schemas"]["Options"] | null;
        };
        /** @description A token, without its secret. */
        TokenView: {
            /** @description Its name: 1 to 40 letters, digits, dots, dashes and spaces. */
            name: string;
            /** @description The role of its holder. */
            role: components["schemas"]["Role"];
            /**
             * @description Whether it is shared by several people, each identified by the name that they give; any
             *     other token belongs to one person, identified by its name.
             * @default false
             */
            shared: boolean;
        };
        /** @description The role of a client; each role includes the ones before it. */
        Role: "watch" | "queue" | "control" | "admin";
        /** @description A newly created token. */
        NewToken: {
            /** @description Its name. */
            name: string;
            /** @description The role of its holder. */
            role: components["schemas"]["Role"];
            /** @description The secret, which is not shown again. */
            secret: string;
        };
        /**
         * @description The complete state of a world at a moment, to be stored, sent and drawn. Lengths are rounded to a
         *     thousandth of a millimetre.
         */
        WorldState: {
            /**
             * Format: double
             * @description The time, in seconds since power-up.
             */
            time_s: number;
            /** @description The true state of the arm; `None` before the first update. */
            arm?: components["schemas"]["TrueArm"] | null;
            /** @description The mounted tool. */
            tool: components["schemas"]["WorldTool"];
            /**
             * Format: double
             * @description The height of the table in the base frame.
             */
            table_z_mm: number;
            /** @description The paper. */
            paper?: components["schemas"]["Paper"] | null;
            /** @description The objects at their current positions. */
            objects: components["schemas"]["WorldObject"][];
            /** @description The names of the objects that move with the tool: the gripped one first, then those on it. */
            held: string[];
            /** @description The ink, in the order in which it was drawn. */
            strokes: components["schemas"]["InkStroke"][];
            /** @description The lines burned by the laser. */
            burns: components["schemas"]["Burn"][];
            /** @description The holes burned by the standing laser. */
            holes: components["schemas"]["Hole"][];
            /**
             * Format: uint64
             * @description The total number of events.
             */
            event_count: number;
            /** @description The last events, at most 100, oldest first. */
            events: components["schemas"]["Happened"][];
        };
        /** @description The true pose of an arm and its actuators. */
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
             * @description The rotation of the tool in the base frame.
             */
            rotation_deg: number;
            /**
             * Format: double
             * @description The height of the tip above the table.
             */
            tip_mm: number;
            /** @description Whether the pump is on. */
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
             * @description The opening of a gripper's fingers; 0 with another tool.
             */
            opening_mm: number;
        };
        /**
         * @description The tool of a scene.
         *
         *     Heights are measured at the table: lower the arm until the tip touches the table; the z that the
         *     arm then reports is `down_z_mm`. The height of the tip above the table is z less `down_z_mm`.
         */
        WorldTool: {
            /**
             * Format: double
             * @description Z of the wrist when the tip touches the table, in the base frame.
             */
            down_z_mm: number;
            /**
             * Format: double
             * @description The compliance of the tip before a collision is reported: a pen has a spring, a cup is soft.
             */
            give_mm: number;
            /** @description The kind of tool. */
            kind: components["schemas"]["ToolAction"];
        };
        /** @description The kind of a tool and its effect on the scene. */
        ToolAction: {
            /** @constant */
            type: "pen";
            /**
             * Format: double
             * @description The line width.
             */
            width_mm: number;
        } | {
            /** @constant */
            type: "laser";
            /**
             * Format: double
             * @description The distance from its tip down to its focus.
             */
            focus_mm: number;
            /**
             * Format: double
             * @description The range above and below the focus in which it burns.
             */
            depth_mm: number;
            /**
             * Format: double
             * @description Its power, in watts; the protocol has on and off only.
             */
            power_w: number;
        } | {
            /** @constant */
            type: "suction_cup";
            /**
             * Format: double
             * @description The diameter; it holds only objects that it covers completely.
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
             * @description The opening with the servo at 0 degrees.
             */
            open_mm: number;
            /**
             * Format: double
             * @description The opening with the servo at 90 degrees.
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
        /** @description An object on the table or held by the tool. */
        WorldObject: {
            /** @description The unique name. */
            name: string;
            /** @description The shape and size. */
            shape: components["schemas"]["Shape"];
            /**
             * Format: double
             * @description The mass in grams.
             */
            mass_g: number;
            /** @description The colour, as `#rrggbb`. */
            color: string;
            /** @description The centre. */
            at_mm: number[];
            /**
             * Format: double
             * @description The rotation about the vertical, counter-clockwise.
             */
            turn_deg: number;
            /**
             * Format: double
             * @description The height of its underside above the table.
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
             * @description The diameter.
             */
            diameter_mm: number;
            /**
             * Format: double
             * @description The height.
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
        /** @description An event with its time. */
        Happened: {
            /**
             * Format: double
             * @description The time in seconds since power-up.
             */
            at_s: number;
        } & ({
            /** @constant */
            event: "picked_up";
            /** @description The object. */
            object: string;
            /**
             * Format: uint
             * @description The number of objects on it.
             */
            with: number;
        } | {
            /** @constant */
            event: "too_heavy";
            /** @description The object. */
            object: string;
            /**
             * Format: double
             * @description The mass including all objects on it.
             */
            mass_g: number;
            /**
             * Format: double
             * @description The load limit of the tool.
             */
            lifts_g: number;
        } | {
            /** @constant */
            event: "draws_air";
            /** @description The object. */
            object: string;
            /**
             * Format: double
             * @description The overhang of the cup.
             */
            by_mm: number;
        } | {
            /** @constant */
            event: "dropped";
            /** @description The object. */
            object: string;
            /** @description The object or surface it landed on. */
            onto: string;
            /**
             * Format: double
             * @description The height of its fall.
             */
            fell_mm: number;
        } | {
            /** @constant */
            event: "collided";
            /** @description The tool or the held object. */
            what: string;
            /** @description The obstacle. */
            with: string;
            /**
             * Format: double
             * @description The depth.
             */
            depth_mm: number;
            /** @description The position. */
            at_mm: number[];
        } | {
            /** @constant */
            event: "burns_on_the_spot";
            /** @description The position. */
            at_mm: number[];
            /**
             * Format: double
             * @description The duration until now.
             */
            time_s: number;
        } | {
            /** @constant */
            event: "off_paper";
            /** @description The position. */
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
        /** @description The new faults. */
        NewFaults: {
            /** @description The faults, in the format of `dobot arm --fault`; times count from now. */
            faults: string[];
            /**
             * Format: uint64
             * @description The random seed: the same faults with the same seed have the same effect.
             * @default 0
             */
            seed: number;
        };
        /** @description A virtual arm for the test of a program. */
        TestArm: {
            /**
             * Format: uint64
             * @description Its number, for `DELETE`.
             */
            arm: number;
            /**
             * Format: uint16
             * @description Its TCP port, at the address of the station.
             */
            port: number;
        };
        /** @description The virtual arm to start. */
        NewTestArm: {
            /**
             * @description Its behaviour: `specification` (default), or `firmware-1.1` for an arm as sold.
             * @default specification
             */
            personality: string;
            /**
             * @description The simulation speed: 0.1 to 1000 times real time, or `max`; default 1.
             * @default 1
             */
            time_factor: string;
            /**
             * @description Its faults, in the format of `dobot arm --fault`.
             * @default []
             */
            faults: string[];
            /**
             * Format: uint64
             * @description The random seed of the faults; default 0.
             * @default 0
             */
            seed: number;
            /**
             * @description The TOML text of its surroundings, as those of `examples/scenes`.
             * @default null
             */
            scene: string | null;
        };
        /** @description A fleet, as one of its stations sees it. */
        FleetView: {
            /** @description The fleet name of the reporting station. */
            name: string;
            /**
             * Format: double
             * @description The time since the reporting station started, in seconds.
             */
            at_s: number;
            /** @description All stations seen, including this one, by name. */
            members: components["schemas"]["Member"][];
        };
        /** @description A station of a fleet, as another one sees it. */
        Member: {
            /** @description The fleet name, as in `desk-3`. */
            name: string;
            /**
             * @description The station's id, 32 hexadecimal digits, valid as long as its data folder exists: two
             *     stations may claim the same name.
             */
            id: string;
            /** @description Whether this is the reporting station. */
            here: boolean;
            /** @description Whether the station can be reached. */
            presence: components["schemas"]["Presence"];
            /**
             * Format: double
             * @description When it was last heard, in seconds since the reporting station started (no other clock is
             *     involved).
             */
            heard_at_s: number;
            /** @description A description of the station; absent until it has sent one. */
            about?: components["schemas"]["MemberAbout"] | null;
            /** @description The last state it sent; absent until it has sent one. */
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
            /** @description The reason, and what to do. */
            problem: components["schemas"]["Problem"];
        };
        /** @description A description of a fleet station. */
        MemberAbout: {
            /** @description The program version. */
            version: string;
            /** @description The address of its page for other machines; absent if it serves its own machine only. */
            page?: string | null;
            /** @description The station's groups, as in `room-2`. */
            groups: string[];
            /** @description The equipment it offers for jobs, as in `pen`, `laser`, `a5`. */
            offers: string[];
            /** @description Whether its arm is virtual. */
            is_virtual: boolean;
            /** @description How it handles fleet jobs; absent if it accepts none. */
            takes_work?: components["schemas"]["TakesWork"] | null;
            /**
             * Format: uint16
             * @description The number of virtual arms it hosts for members without an arm; absent if none.
             */
            gives_arms?: number | null;
            /** @description The station that hosts this virtual arm; absent for any other arm. */
            given_by?: string | null;
        };
        /** @description How a station handles fleet jobs. */
        TakesWork: "queue" | "start";
        /** @description A stop of several stations. */
        FleetStop: {
            /**
             * @description The stations; all if absent.
             * @default all
             */
            to: components["schemas"]["Recipients"];
            /** @description The reason, shown at the stopped arms. */
            reason?: string | null;
        };
        /** @description The stations of a fleet that a request goes to. */
        Recipients: "all" | {
            group: string;
        } | {
            members: string[];
        };
        /** @description The answer of one fleet station. */
        MemberAnswer: {
            /** @description The fleet name. */
            member: string;
            /** @description The station's id. */
            id: string;
            /** @description The answer, or a problem if none came: the request may still have been carried out. */
            answer: components["schemas"]["ApiAnswer"];
            /**
             * Format: double
             * @description The time until the answer, in milliseconds.
             */
            took_ms: number;
        };
        /** @description A station's answer to an API request. */
        ApiAnswer: {
            /**
             * Format: uint16
             * @description The HTTP status.
             */
            status: number;
            /** @description The body: JSON; a problem if the status is 400 or above; a string if it is not JSON. */
            body: unknown;
        };
        /** @description A request to several stations. */
        FleetRequest: {
            /** @description The stations. */
            to: components["schemas"]["Recipients"];
            /** @description The method, as in `POST`. */
            method: string;
            /** @description The path with its query, as in `/api/v1/jobs/pause`. */
            path: string;
            /**
             * @description The token of a lease, if one station is addressed.
             * @default null
             */
            lease: string | null;
            /**
             * @description The sender's key of this request.
             * @default null
             */
            key: string | null;
            /**
             * @description The body, if any.
             * @default null
             */
            body: unknown;
        };
        /** @description A drawing or a program for any arm. */
        FleetWork: {
            /**
             * @description A drawing; the station that takes it plans it for its own arm.
             * @default null
             */
            drawing: components["schemas"]["NewDrawing"] | null;
            /**
             * @description A job. Its positions are those of this station's arm: an arm with another calibration
             *     refuses it.
             * @default null
             */
            job: components["schemas"]["NewJob"] | null;
            /**
             * @description The features that an arm must offer, as in `["pen", "a5"]`.
             * @default []
             */
            needs: string[];
            /**
             * @description The student who owns it; by default the caller.
             * @default null
             */
            student: string | null;
            /**
             * @description The student's group.
             * @default null
             */
            group: string | null;
        };
        /** @description A fleet job: a drawing or a program that one arm of the fleet runs once. */
        WorkView: {
            /** @description The id: 32 hexadecimal digits. */
            id: string;
            /** @description The title. */
            title: string;
            /** @description The student. */
            student: string;
            /** @description The student's group. */
            group?: string | null;
            /** @description The equipment the arm must have, as in `pen`, `a5`. */
            needs: string[];
            /**
             * Format: int64
             * @description When it was submitted, in milliseconds since 1970-01-01T00:00:00Z.
             */
            submitted_ms: number;
            /** @description The phase. */
            phase: components["schemas"]["WorkPhase"];
            /**
             * @description Why it is unknown whether it is or will be drawn: no other arm gets it until that is known
             *     or a person decides.
             */
            doubt?: string | null;
            /** @description Why it waits, or how it ended. */
            reason?: string | null;
            /** @description The station that was offered it or has it. */
            member?: components["schemas"]["WorkMember"] | null;
            /** @description The job at that station, as last reported. */
            job?: components["schemas"]["JobView"] | null;
            /** @description The stations from which a person has withdrawn it, and what may have been drawn there. */
            before?: components["schemas"]["WorkBefore"][];
        };
        /** @description The phase of a fleet job. */
        WorkPhase: "waiting" | "offered" | "taken" | "done" | "failed" | "cancelled";
        /** @description A station that a fleet job was offered to. */
        WorkMember: {
            /** @description The fleet name. */
            name: string;
            /** @description The station's id. */
            id: string;
        };
        /** @description A station from which a person has withdrawn a fleet job that was in doubt or had failed. */
        WorkBefore: {
            /** @description The station. */
            member: components["schemas"]["WorkMember"];
            /** @description What may have been drawn there, in words. */
            drawn: string;
            /** @description Whether that station has answered since, so nothing more is drawn there. */
            is_settled: boolean;
        };
        /** @description A job that a station offers: a drawing or a list of commands. */
        FleetOffer: {
            /** @description The name of the offering station. */
            by: string;
            /** @description The student who owns the job. */
            student: string;
            /** @description A drawing, which is planned here. */
            drawing?: components["schemas"]["NewDrawing"] | null;
            /** @description A job. */
            job?: components["schemas"]["NewJob"] | null;
            /** @description The calibration of the arm for which the job's positions were computed, as ten numbers. */
            made_for?: number[] | null;
        };
        /** @description The virtual arms that a station hosts for members without an arm. */
        GivenArms: {
            /**
             * Format: uint16
             * @description The maximum number at a time.
             */
            most: number;
            /**
             * Format: uint64
             * @description The time after which an arm that no client watches ends, in seconds.
             */
            unused_s: number;
            /** @description The hosted arms. */
            arms: components["schemas"]["GivenArm"][];
        };
        /** @description A hosted virtual arm: a fleet station like any other. */
        GivenArm: {
            /** @description The fleet name. */
            name: string;
            /** @description The address of its page. */
            page: string;
        };
        /** @description A request for a virtual arm. */
        WantedVirtualArm: {
            /**
             * @description Its name in the fleet: 1 to 40 lowercase letters a to z, digits and hyphens, beginning with
             *     a letter.
             */
            name: string;
        };
        /** @description A message from the station over the WebSocket. */
        ToClient: {
            /** @description Information for the client. */
            hello: components["schemas"]["Hello"];
        } | {
            /** @description The state. */
            state: components["schemas"]["State"];
        } | {
            /** @description The notice. */
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
            /** @description The problem. */
            problem: components["schemas"]["Problem"];
        };
        /** @description Information for a client that has connected. */
        Hello: {
            /** @description The client's number. */
            client: components["schemas"]["ClientId"];
            /** @description The client's role. */
            role: components["schemas"]["Role"];
            /**
             * @description The person the client counts as for time slots: the name of its token if the token belongs
             *     to a person, otherwise the client's name.
             * @default
             */
            person: string;
            /** @description The version of the station. */
            version: string;
            /** @description The name of the station in its fleet, if it belongs to one. */
            fleet?: string | null;
            /**
             * @description The version of the station's page, as in the address of its files.
             * @default
             */
            page: string;
            /**
             * Format: double
             * @description The dead-man time: how long a jog button stays pressed without a repeated request, in
             *     seconds.
             */
            dead_man_s: number;
        };
        /** @description A packet between the station and the arm. */
        PacketView: {
            /** @constant */
            direction: "to_arm";
            /**
             * Format: double
             * @description The time, in seconds since the station started.
             */
            at_s: number;
            /** @description Its 42 bytes, in hexadecimal digits. */
            bytes: string;
            /** @description The command, by the dialect of the arm; absent if it is invalid. */
            command?: components["schemas"]["Command"] | null;
            /** @description The reason why it is invalid. */
            problem?: string | null;
        } | {
            /** @constant */
            direction: "from_arm";
            /**
             * Format: double
             * @description The time, in seconds since the station started.
             */
            at_s: number;
            /** @description Its 42 bytes, in hexadecimal digits. */
            bytes: string;
            /** @description The status. */
            status?: components["schemas"]["Status"] | null;
        };
        /** @description A message from a client over the WebSocket. */
        FromClient: {
            /**
             * Format: uint64
             * @description A number, repeated in the answer.
             */
            id: number;
            /** @description The request. */
            request: components["schemas"]["Request"];
        };
        /** @description A request to the station. */
        Request: {
            /** @constant */
            type: "command";
            /** @description The command. */
            command: components["schemas"]["Command"];
        } | {
            /** @constant */
            type: "sensed_command";
            /** @description The sense. */
            sense: components["schemas"]["Sense"];
            /** @description The command. */
            command: components["schemas"]["Command"];
        } | {
            /** @constant */
            type: "heard";
            /** @description The client whose audio it was; absent for the listener's own microphone. */
            client?: components["schemas"]["ClientId"] | null;
            /** @description What was understood. */
            heard: components["schemas"]["Heard"];
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
             * @description The distance forward of the base axis, in mm.
             */
            x_mm: number;
            /**
             * Format: double
             * @description The distance to the left of the base axis, in mm.
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
             * @description The distance, in mm or degrees.
             */
            by: number;
        } | {
            /** @constant */
            type: "stop";
            /**
             * @description The reason, shown while the arm is stopped. Text beyond 200 characters is cut: a stop is
             *     never refused.
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
            /** @description The client that gets control. */
            to: components["schemas"]["ClientId"];
        } | {
            /** @constant */
            type: "seize_lease";
        } | {
            /** @constant */
            type: "lock";
            /** @description The reason, shown to clients, as in "eyes on me". Text beyond 200 characters is cut. */
            message?: string | null;
        } | {
            /** @constant */
            type: "unlock";
        } | {
            /** @constant */
            type: "set_slots";
            /** @description The slots, in any order: at most 200, not overlapping. */
            slots: components["schemas"]["TimeSlot"][];
        } | {
            /** @constant */
            type: "show_state";
        } | {
            /** @constant */
            type: "show_slots";
        } | {
            /** @constant */
            type: "message";
            /** @description The message. Text beyond 200 characters is cut. */
            text: string;
        } | {
            /** @constant */
            type: "mark_episode";
            /** @description The mark. */
            mark: components["schemas"]["EpisodeMark"];
            /** @description What the arm does; only with `begin`. Text beyond 200 characters is cut. */
            task?: string | null;
        } | {
            /** @constant */
            type: "arm_laser";
            /**
             * Format: double
             * @description The duration, in seconds.
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
            type: "set_angles";
        } | {
            /** @constant */
            type: "calibrate";
            /** @description The calibration; without one the arm is assumed to match the drawing. */
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
             * @description The idempotency key, 1 to 64 visible characters: a request repeated with the same key
             *     queues no second job.
             */
            key?: string | null;
        } | {
            /** @constant */
            type: "start_job";
            /**
             * Format: uint64
             * @description The job number.
             */
            job: number;
        } | {
            /** @constant */
            type: "answer_job";
            /**
             * Format: uint64
             * @description The job.
             */
            job: number;
            /**
             * Format: uint64
             * @description The number of the question; an answer to an earlier question is refused. Absent: the
             *     current question.
             */
            question?: number | null;
            /** @description The answer. */
            answer: components["schemas"]["Answer"];
        } | {
            /** @constant */
            type: "confirm_job";
            /**
             * Format: uint64
             * @description The job number.
             */
            job: number;
        } | {
            /** @constant */
            type: "step_job";
            /**
             * Format: uint64
             * @description The job number.
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
             * @description The speed, in percent of the planned speed.
             */
            percent: number;
        } | {
            /** @constant */
            type: "set_job_height";
            /**
             * Format: double
             * @description The height offset from the plan, in millimetres; negative is lower.
             */
            offset_mm: number;
        } | {
            /** @constant */
            type: "cancel_job";
            /**
             * Format: uint64
             * @description The job number.
             */
            job: number;
        } | {
            /** @constant */
            type: "queue_again";
            /**
             * Format: uint64
             * @description The job number.
             */
            job: number;
            /**
             * @description The idempotency key, 1 to 64 visible characters: a request repeated with the same key
             *     queues no second job.
             */
            key?: string | null;
        } | {
            /** @constant */
            type: "move_job";
            /**
             * Format: uint64
             * @description The job number.
             */
            job: number;
            /**
             * Format: uint64
             * @description The number of the other job; without it, the job moves to the end.
             */
            before?: number | null;
        } | {
            /** @constant */
            type: "forget_job";
            /**
             * Format: uint64
             * @description The job number.
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
            /** @description the page, or one of its files */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/html": string;
                };
            };
            /** @description the file is the one that the browser has */
            304: {
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `job-running`: a job is using the arm
             *     - `detecting`: the dialect is being detected
             *     - `still-moving`: the arm is still moving
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `bad-policy`: the policy is invalid
             *     - `invalid`: a field is invalid
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `bad-policy`: the policy is invalid
             *     - `invalid`: a field is invalid
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
                /** @description Maximum number of states per second, 0 to 1000 (default: every state, 12.5 per second and those with events) */
                states?: number;
                /** @description Whether to send notices (default: true) */
                notices?: boolean;
                /** @description Name of the client, 1 to 60 characters */
                name?: string;
                /** @description Device of a page, shown with its name */
                device?: components["schemas"]["Device"];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description the metrics */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
                /** @description Maximum number of states per second, 0 to 1000 (default: every state, 12.5 per second and those with events) */
                states?: number;
                /** @description Whether to send notices (default: true) */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description the arm has reached the target (with `wait`) */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Reply"];
                };
            };
            /** @description the command is queued */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm is still moving
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job is using the arm
             *     - `detecting`: the dialect is being detected
             *     - `not-reached`: the arm did not reach the end of the command
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `command`: the command cannot be sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
            /** @description the whole path is allowed */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `still-moving`: the arm is still moving
             *     - `laser-disarmed`: the laser is disarmed
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `command`: the command cannot be sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
            /** @description the limits and zones within 20 mm or 5 degrees */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             *     - `invalid`: a field is invalid
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm is still moving
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job is using the arm
             *     - `detecting`: the dialect is being detected
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `command`: the command cannot be sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the step is queued */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm is still moving
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job is using the arm
             *     - `detecting`: the dialect is being detected
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `command`: the command cannot be sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `still-moving`: the arm is still moving
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description a lease token, valid when control is granted */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the new lease holder */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `not-asking`: the client has not asked for control
             *     - `locked`: the arm is locked
             *     - `slot`: the arm is reserved for another student
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the arm is unlocked */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `bad-slots`: the time slots are invalid
             *     - `invalid`: a field is invalid
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
            /** @description no time slots are left */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the message is sent */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description the reported progress */
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
            /** @description - `unauthorised`: an access token is required */
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
             *     - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many`: too many commands are waiting
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `stopped`: the arm is stopped
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `out-of-range`: a number is out of range
             *     - `policy`: the policy does not allow this
             *     - `invalid`: a field is invalid
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `job-running`: a job is using the arm
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the dialect, with the evidence */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm is still moving
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job is using the arm
             *     - `detecting`: the dialect is being detected
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `command`: the command cannot be sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is out of range
             *     - `dialect-not-found`: the dialect could not be detected
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
            /** @description the calibrations */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description the new calibration */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `job-running`: a job is using the arm
             *     - `detecting`: the dialect is being detected
             *     - `still-moving`: the arm is still moving
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm is still moving
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job is using the arm
             *     - `detecting`: the dialect is being detected
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `command`: the command cannot be sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
    post_calibration_bar: {
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
                 *       "sheet": 417,
                 *       "bar_mm": 189.5
                 *     }
                 */
                "application/json": components["schemas"]["MeasuredBar"];
            };
        };
        responses: {
            /** @description the print has its true size */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `bad-touches`: no calibration fits the touched points
             *     - `invalid`: a field is invalid
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
                 *       "sheet": 417,
                 *       "bar_mm": 189.5,
                 *       "touches": [
                 *         {
                 *           "place_mm": [
                 *             215,
                 *             0
                 *           ],
                 *           "raw_deg": [
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
                 *           "raw_deg": [
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
                 *           "raw_deg": [
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
                 *           "raw_deg": [
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
            /** @description the fit */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `bad-touches`: no calibration fits the touched points
             *     - `invalid`: a field is invalid
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
            /** @description the paper */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `bad-touches`: no calibration fits the touched points
             *     - `invalid`: a field is invalid
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
                 *       "sheet": 417,
                 *       "bar_mm": 189.5,
                 *       "touches": [
                 *         {
                 *           "place_mm": [
                 *             215,
                 *             0
                 *           ],
                 *           "raw_deg": [
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
                 *           "raw_deg": [
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
                 *           "raw_deg": [
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
                 *           "raw_deg": [
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `bad-touches`: no calibration fits the touched points
             *     - `invalid`: a field is invalid
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
                /** @description Maximum number of items, 1 to 1000 (default: all) */
                limit?: number;
                /** @description Number or name of the last item of the previous page; the header Link contains the address of the next page */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `out-of-range`: a number is out of range */
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
                /** @description The sender's key of this request: repeated with the same key it queues no second job and returns the existing one */
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
            /** @description the job is queued; the header Location contains its path */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `key-reused`: the key was used for another request
             *     - `bad-job`: the job cannot run
             *     - `policy`: the policy does not allow this
             *     - `command`: the command cannot be sent
             *     - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description the job has ended */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `job-phase`: the job does not allow this now
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `bad-job`: the job cannot run */
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
    get_jobs_id_sketch: {
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
            /** @description the picture */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Sketch"] | null;
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `bad-job`: the job cannot run */
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
                /** @description The sender's key of this request: repeated with the same key it queues no second job and returns the existing one */
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
            /** @description the job is queued; the header Location contains its path */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `key-reused`: the key was used for another request
             *     - `bad-job`: the job cannot run
             *     - `policy`: the policy does not allow this
             *     - `command`: the command cannot be sent
             *     - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
            /** @description the job is moved */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the job is deleted */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm is still moving
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job is using the arm
             *     - `detecting`: the dialect is being detected
             *     - `job-phase`: the job does not allow this now
             *     - `cannot-resume`: the job cannot be resumed
             *     - `needs-a-person`: a person has to confirm this
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `command`: the command cannot be sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is out of range
             *     - `bad-job`: the job cannot run
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
            /** @description the job can be resumed */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the step is running */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `stopped`: the arm is stopped
             *     - `still-moving`: the arm is still moving
             *     - `laser-disarmed`: the laser is disarmed
             *     - `job-running`: a job is using the arm
             *     - `detecting`: the dialect is being detected
             *     - `job-phase`: the job does not allow this now
             *     - `cannot-resume`: the job cannot be resumed
             *     - `needs-a-person`: a person has to confirm this
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `command`: the command cannot be sent
             *     - `policy`: the policy does not allow this
             *     - `out-of-range`: a number is out of range
             *     - `bad-job`: the job cannot run
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `no-job-runs`: no job is running
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the job runs at this speed */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `no-job-runs`: no job is running
             *     - `still-moving`: the arm is still moving
             *     - `no-vectors`: the job has no vectors
             *     - `cannot-resume`: the job cannot be resumed
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
            /** @description the job runs at this height */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `slot`: the arm is reserved for another student
             *     - `no-job-runs`: no job is running
             *     - `still-moving`: the arm is still moving
             *     - `no-vectors`: the job has no vectors
             *     - `cannot-resume`: the job cannot be resumed
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `out-of-range`: a number is out of range
             *     - `policy`: the policy does not allow this
             *     - `invalid`: a field is invalid
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
    post_jobs_id_answer: {
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
                 *       "answer": "red"
                 *     }
                 */
                "application/json": components["schemas"]["ChosenAnswer"];
            };
        };
        responses: {
            /** @description the program continues */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `no-question`: the job does not wait for an answer
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `bad-answer`: the answer does not fit
             *     - `invalid`: a field is invalid
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
    put_jobs_id_places_name: {
        parameters: {
            query?: never;
            header?: {
                /** @description The token of a lease that was taken with `POST /api/v1/lease` */
                "Dobot-Lease"?: string;
            };
            path: {
                id: number;
                name: string;
            };
            cookie?: never;
        };
        /** @description Up to 64 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "x_mm": 200,
                 *       "y_mm": 50,
                 *       "z_mm": -20
                 *     }
                 */
                "application/json": components["schemas"]["GivenPlace"];
            };
        };
        responses: {
            /** @description the program continues */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `no-question`: the job does not wait for an answer
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `bad-answer`: the answer does not fit
             *     - `invalid`: a field is invalid
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
            /** @description the report, also of a program with problems */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `bad-program`: the program cannot run
             *     - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
    post_programs_merge: {
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
                 *       "text": "[[steps]]\npause = 1 # a moment\n",
                 *       "content": "[[steps]]\npause = 2\n"
                 *     }
                 */
                "application/json": components["schemas"]["MergeProgram"];
            };
        };
        responses: {
            /** @description the text, which may have problems */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MergedProgram"];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `bad-program`: the program cannot run
             *     - `invalid`: a field is invalid
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `bad-program`: the program cannot run
             *     - `invalid`: a field is invalid
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
                /** @description The sender's key of this request: repeated with the same key it queues no second job and returns the existing one */
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
            /** @description the job is queued; the header Location contains its path */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             * @description - `key-reused`: the key was used for another request
             *     - `bad-program`: the program cannot run
             *     - `bad-job`: the job cannot run
             *     - `policy`: the policy does not allow this
             *     - `command`: the command cannot be sent
             *     - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
    get_buttons: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the buttons, in the order in which they were added */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CustomButton"][];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `button-file`: the buttons cannot be read or written */
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
    post_buttons: {
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
                 *       "name": "Lift",
                 *       "color": "blue",
                 *       "action": {
                 *         "type": "program",
                 *         "text": "[[steps]]\ngo = { x = 200, y = 0, z = 80 }\n"
                 *       }
                 *     }
                 */
                "application/json": components["schemas"]["CustomButton"];
            };
        };
        responses: {
            /** @description all buttons */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CustomButton"][];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `button-taken`: another button has this name
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `bad-button`: the button is invalid
             *     - `invalid`: a field is invalid
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
            /** @description - `button-file`: the buttons cannot be read or written */
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
    delete_buttons_name: {
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
            /** @description the remaining buttons */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CustomButton"][];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `no-such-button`: there is no such button */
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
            /** @description - `button-file`: the buttons cannot be read or written */
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
    get_talk: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description whether a listener runs */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Listener"];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
    get_talk_audio: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the pieces, in the order in which they were sent */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TalkPiece"][];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
    post_episodes: {
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
                 *       "mark": "begin",
                 *       "task": "Pick up the cube."
                 *     }
                 */
                "application/json": components["schemas"]["NewMark"];
            };
        };
        responses: {
            /** @description the mark is recorded */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
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
             * @description - `not-recorded`: nothing is recorded
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
    get_recordings: {
        parameters: {
            query?: {
                /** @description Maximum number of items, 1 to 1000 (default: all) */
                limit?: number;
                /** @description Number or name of the last item of the previous page; the header Link contains the address of the next page */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `out-of-range`: a number is out of range */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
                /** @description Begin, in seconds since the origin of the recording (default: 0) */
                from_s?: number;
                /** @description End (default: the end of the recording) */
                to_s?: number;
                /** @description Maximum number of samples, 2 to 5000 (default: 2000) */
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
            /** @description the positions of the arm */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `out-of-range`: a number is out of range */
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
            /** @description the drawing is being planned; the header Location contains its path */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `no-such-file`: there is no such file */
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
            /** @description - `files-unusable`: the files cannot be read or written */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description the drawing is deleted */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
                /** @description The sender's key of this request: repeated with the same key it queues no second job and returns the existing one */
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
            /** @description the job is queued; the header Location contains its path */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `key-reused`: the key was used for another request
             *     - `bad-drawing`: it cannot be drawn
             *     - `bad-job`: the job cannot run
             *     - `policy`: the policy does not allow this
             *     - `command`: the command cannot be sent
             *     - `out-of-range`: a number is out of range
             *     - `invalid`: a field is invalid
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
             * @description - `too-many`: too many commands are waiting
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
    get_files: {
        parameters: {
            query?: {
                /** @description Text that the names contain, whatever its case (default: all files) */
                search?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the files */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FilesView"];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `files-unusable`: the files cannot be read or written */
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
    post_files: {
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
                 *       "name": "dot.hpgl",
                 *       "content": "SU47UFUwLDA7UEQ0MDAsMDtQVTs="
                 *     }
                 */
                "application/json": components["schemas"]["NewFile"];
            };
        };
        responses: {
            /** @description the file was already there, with this content */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FileView"];
                };
            };
            /** @description the file is stored; the header Location contains its path */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FileView"];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `file-exists`: another file has this name
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `bad-drawing`: it cannot be drawn
             *     - `file-name`: no file can have this name
             *     - `invalid`: a field is invalid
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
            /**
             * @description - `files-full`: the space for files is used up
             *     - `files-unusable`: the files cannot be read or written
             */
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
    get_files_id: {
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
            /** @description the file */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FileView"];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `no-such-file`: there is no such file */
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
            /** @description - `files-unusable`: the files cannot be read or written */
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
    put_files_id: {
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
        /** @description Up to 32768 KiB */
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "revision": 1,
                 *       "options": {
                 *         "place": {
                 *           "at": [
                 *             200,
                 *             20
                 *           ]
                 *         }
                 *       }
                 *     }
                 */
                "application/json": components["schemas"]["ChangeFile"];
            };
        };
        responses: {
            /** @description the file */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FileView"];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `no-such-file`: there is no such file */
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
             * @description - `file-exists`: another file has this name
             *     - `file-changed`: the file has changed
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `bad-drawing`: it cannot be drawn
             *     - `file-name`: no file can have this name
             *     - `invalid`: a field is invalid
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
            /**
             * @description - `files-full`: the space for files is used up
             *     - `files-unusable`: the files cannot be read or written
             */
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
    delete_files_id: {
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
            /** @description the file is deleted */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `no-such-file`: there is no such file */
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
            /** @description - `files-unusable`: the files cannot be read or written */
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
    get_files_id_content: {
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
            /** @description the content */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `no-such-file`: there is no such file */
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
            /** @description - `files-unusable`: the files cannot be read or written */
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
    get_files_id_sketch: {
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
            /** @description the picture */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Sketch"] | null;
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `no-such-file`: there is no such file */
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
            /** @description - `files-unusable`: the files cannot be read or written */
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
    get_extras: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description their names */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
    get_extras_extra_file: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                extra: string;
                file: string;
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `no-such-file`: there is no such file */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             *     - `lease-gone`: the lease token is no longer valid
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
             *     - `invalid`: a field is invalid
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
            /** @description the remaining tokens */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
    get_addresses: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the addresses, as in http://192.168.1.7:8642 */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
    get_world: {
        parameters: {
            query?: {
                /** @description Index of the first line of ink and burns, counted from 0; the last line may still grow */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `not-virtual`: the arm is not a virtual arm of this station */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `not-virtual`: the arm is not a virtual arm of this station
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `bad-scene`: the scene is invalid
             *     - `invalid`: a field is invalid
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `not-virtual`: the arm is not a virtual arm of this station */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `not-virtual`: the arm is not a virtual arm of this station
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `bad-fault`: the fault is invalid
             *     - `invalid`: a field is invalid
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
    "get_virtual-arms": {
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
                    "application/json": components["schemas"]["TestArm"][];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
    "post_virtual-arms": {
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
                 *       "personality": "firmware-1.1",
                 *       "time_factor": "10"
                 *     }
                 */
                "application/json": components["schemas"]["NewTestArm"];
            };
        };
        responses: {
            /** @description the virtual arm */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TestArm"];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `all-arms-given`: all virtual arms are in use
             *     - `lease-gone`: the lease token is no longer valid
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
             * @description - `invalid`: a field is invalid
             *     - `bad-fault`: the fault is invalid
             *     - `bad-scene`: the scene is invalid
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
    "delete_virtual-arms_arm": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                arm: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the remaining virtual arms */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TestArm"][];
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description the response of each */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the response of each */
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
            /** @description - `unauthorised`: an access token is required */
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
             *     - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the response of each */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description - `unauthorised`: an access token is required */
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
             *     - `forbidden-host`: unknown host name
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
            /** @description - `invalid`: a field is invalid */
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
                /** @description The sender's key of this request: repeated with the same key it queues no second job and returns the existing one */
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
            /** @description the job waits for an arm */
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
            /** @description - `unauthorised`: an access token is required */
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
             *     - `forbidden-host`: unknown host name
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
            /** @description - `lease-gone`: the lease token is no longer valid */
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
            /** @description - `invalid`: a field is invalid */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many`: too many commands are waiting
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
            /** @description - `work-file`: the fleet job cannot be saved */
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
            /** @description the job is cancelled, or is being withdrawn */
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
            /** @description - `unauthorised`: an access token is required */
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
             *     - `forbidden-host`: unknown host name
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
             *     - `no-such-work`: there is no such fleet job
             */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `work-phase`: the fleet job does not allow this now */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is invalid */
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
            /** @description the job waits for another arm */
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
            /** @description - `unauthorised`: an access token is required */
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
             *     - `forbidden-host`: unknown host name
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
             *     - `no-such-work`: there is no such fleet job
             */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `work-phase`: the fleet job does not allow this now */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /** @description - `invalid`: a field is invalid */
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
                /** @description The sender's key of this request: repeated with the same key it queues no second job and returns the existing one */
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
            /** @description the accepted job */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `arm-busy`: the arm has another job
             *     - `work-refused`: the station does not accept this fleet job
             *     - `drawing-phase`: the drawing is not planned yet
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `too-many`: too many commands are waiting
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
            /** @description the accepted job in its current state */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `no-such-work`: there is no such fleet job */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `arm-busy`: the arm has another job
             *     - `work-refused`: the station does not accept this fleet job
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
            /** @description the accepted job in its current state */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
            /** @description - `no-such-work`: there is no such fleet job */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            /**
             * @description - `arm-busy`: the arm has another job
             *     - `work-refused`: the station does not accept this fleet job
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
            /** @description - `unauthorised`: an access token is required */
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
             *     - `forbidden-host`: unknown host name
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
            /** @description - `gives-no-arms`: this station hosts no virtual arms */
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
            /** @description - `unauthorised`: an access token is required */
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
             *     - `forbidden-host`: unknown host name
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
             * @description - `gives-no-arms`: this station hosts no virtual arms
             *     - `name-taken`: another station has this name
             *     - `all-arms-given`: all virtual arms are in use
             *     - `lease-gone`: the lease token is no longer valid
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the remaining virtual arms */
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
            /** @description - `unauthorised`: an access token is required */
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
             *     - `forbidden-host`: unknown host name
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
            /** @description - `gives-no-arms`: this station hosts no virtual arms */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `not-built`: not included in this build
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the message is accepted, without a response */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `not-built`: not included in this build
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
            /** @description - `invalid`: a field is invalid */
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
            /** @description the session has ended */
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
            /** @description - `unauthorised`: an access token is required */
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
             * @description - `forbidden-host`: unknown host name
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
             * @description - `not-built`: not included in this build
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
            /** @description - `invalid`: a field is invalid */
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
